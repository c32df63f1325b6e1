#include "app/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace spindrift::app {

FolderLock::FolderLock(const std::filesystem::path& folder, bool wait) {
  const std::filesystem::path file = folder / ".lock";
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw std::runtime_error(fmt::format("cannot write {}: {}", file.string(), strerror(errno)));
  int result;
  do
    result = ::flock(descriptor_, LOCK_EX | (wait ? 0 : LOCK_NB));
  while (result != 0 && errno == EINTR);
  if (result == 0)
    return;
  const int error = errno;
  ::close(descriptor_);
  throw std::runtime_error(
      error == EWOULDBLOCK
          ? fmt::format(
                "{}: another sweep is at work here; wait for it, or give another folder (-o)",
                folder.string())
          : fmt::format("cannot lock {}: {}", file.string(), strerror(error)));
}

FolderLock::~FolderLock() {
  ::close(descriptor_);
}

}  // namespace spindrift::app
