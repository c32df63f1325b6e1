#include "app/system/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

namespace spindrift::app {
namespace {

constexpr int stop_check_milliseconds = 100;

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {
    if (number < 0)
      fail(errno, "no descriptor for another program");
  }
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0)
      ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

/// A file in memory. Unlike a pipe it never fills, so that writing to it waits for no reader.
Descriptor memory_file() {
  return Descriptor(::memfd_create("spindrift", MFD_CLOEXEC));
}

void write_all(const Descriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno != EINTR)
      fail(errno, "cannot hand over the input of another program");
    if (written > 0)
      text.remove_prefix(static_cast<std::size_t>(written));
  }
  ::lseek(file.number(), 0, SEEK_SET);
}

/// Appends what can be read now.
/// @return false at the end of the file
bool read_some(const Descriptor& file, std::string& text) {
  char bytes[16384];
  const ssize_t count = ::read(file.number(), bytes, sizeof bytes);
  if (count > 0)
    text.append(bytes, static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

pid_t spawn(const std::vector<std::string>& command, int in, int out, int err) {
  std::vector<char*> arguments;
  for (const std::string& word : command)
    arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  posix_spawnattr_t attributes;  // restore the signals that this process ignores
  ::posix_spawnattr_init(&attributes);
  sigset_t usual;
  ::sigemptyset(&usual);
  ::sigaddset(&usual, SIGPIPE);
  ::sigaddset(&usual, SIGXFSZ);
  ::posix_spawnattr_setsigdefault(&attributes, &usual);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    fail(error, command[0]);
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                          const std::atomic<bool>& stop) {
  const Descriptor in = memory_file(), err = memory_file();
  write_all(in, input);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    fail(errno, "no pipe for another program");
  const Descriptor out(ends[0]);
  Descriptor out_of_child(ends[1]);
  const pid_t child = spawn(command, in.number(), out_of_child.number(), err.number());
  out_of_child.close();

  ProcessResult result;
  for (pollfd ready{out.number(), POLLIN, 0};;) {
    if (stop)
      ::kill(child, SIGKILL);
    if (::poll(&ready, 1, stop_check_milliseconds) > 0 && !read_some(out, result.out))
      break;
  }
  result.exit_code = wait_for(child);
  ::lseek(err.number(), 0, SEEK_SET);
  while (read_some(err, result.err)) {
  }
  return result;
}

}  // namespace spindrift::app
