#include "app/system/standard_streams.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>

#include "app/errors/errors.hpp"
#include "app/system/machine_limits.hpp"

namespace spindrift::app {
namespace {

/// Writes to standard error and drops what can't be written, so that the stream never fails.
ssize_t write_what_can_be(void*, const char* text, std::size_t size) {
  std::size_t written = 0;
  while (written < size) {
    const ssize_t count = ::write(STDERR_FILENO, text + written, size - written);
    if (count < 0 && errno != EINTR)
      break;
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return static_cast<ssize_t>(size);
}

/// Ends the process with a sentence about the error that nothing has caught.
[[noreturn]] void end_in_words() {
  try {
    if (const std::exception_ptr error = std::current_exception())
      std::rethrow_exception(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "spindrift: {}\n", reason_of(error));
    ::_exit(run_failed);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void prepare_process() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  if (FILE* stream = ::fopencookie(
          nullptr, "w",
          {.read = nullptr, .write = write_what_can_be, .seek = nullptr, .close = nullptr})) {
    std::setvbuf(stream, nullptr, _IONBF, 0);
    stderr = stream;
  }
  std::set_terminate(end_in_words);
}

bool all_printed() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return true;
  if (errno != EPIPE)
    fmt::print(stderr, "spindrift: cannot write to the standard output: {}\n", strerror(errno));
  return false;
}

}  // namespace spindrift::app
