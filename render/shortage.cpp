#include "render/shortage.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace spindrift {
namespace {

/// Names the limit that a user has set, as a shell does, or returns an empty text where there is
/// none.
std::string limit_text(__rlimit_resource resource, const char* option, rlim_t unit,
                       const char* unit_name) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return "";
  return fmt::format("; the limit is {} {} (ulimit {})", limit.rlim_cur / unit, unit_name, option);
}

bool gives_memory(std::size_t bytes) {
  void* const place = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED)
    return false;
  ::munmap(place, bytes);
  return true;
}

bool gives_thread() {
  pthread_t thread{};
  if (::pthread_create(
          &thread, nullptr, [](void*) -> void* { return nullptr; }, nullptr) != 0)
    return false;
  ::pthread_join(thread, nullptr);
  return true;
}

bool gives_file() {
  const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (file >= 0)
    ::close(file);
  return file >= 0 || (errno != EMFILE && errno != ENFILE);
}

}  // namespace

std::optional<std::string> shortage(std::size_t bytes) {
  constexpr std::size_t mib = std::size_t{1} << 20;
  if (!gives_memory(bytes))
    return fmt::format("the system gives this process no {} MiB of memory more{}", bytes / mib,
                       limit_text(RLIMIT_AS, "-v", 1024, "KiB"));
  if (!gives_thread())
    return fmt::format("the system gives this process no thread more{}",
                       limit_text(RLIMIT_NPROC, "-u", 1, "processes and threads of this user"));
  if (!gives_file())
    return fmt::format("the system lets this process open no file more{}",
                       limit_text(RLIMIT_NOFILE, "-n", 1, "files"));
  return std::nullopt;
}

}  // namespace spindrift
