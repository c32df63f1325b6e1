#include "render/output/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace spindrift::output {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error(file.string() + ": " + reason);
}

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

/// Says what a path names that does not name a regular file.
const char* kind_name(mode_t mode) {
  if (S_ISDIR(mode))
    return "is a folder, not a file";
  if (S_ISFIFO(mode))
    return "is a pipe (FIFO), not a file";
  if (S_ISSOCK(mode))
    return "is a socket, not a file";
  return "is a device, not a file";
}

/// Opens a regular file for reading, sets `size` to its size in bytes, and returns its descriptor.
/// Without O_NONBLOCK, opening a pipe would wait for somebody to write to it.
int open_regular(const std::filesystem::path& file, std::size_t& size) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) {
    if (errno == ENXIO)
      fail(file, kind_name(S_IFSOCK));
    fail(file, errno == ENOENT ? "there is no such file"
                               : std::string("cannot be read: ") + std::strerror(errno));
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    fail(file, kind_name(status.st_mode));
  }
  size = static_cast<std::size_t>(status.st_size);
  return descriptor;
}

}  // namespace

void require_regular_file(const std::filesystem::path& file) {
  std::size_t size = 0;
  const Descriptor descriptor(open_regular(file, size));
}

std::string read_file(const std::filesystem::path& file) {
  std::size_t size = 0;
  const Descriptor descriptor(open_regular(file, size));
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(descriptor.number(), bytes.data() + done, size - done);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(file, std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0)
      break;  // the file has become shorter meanwhile
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace spindrift::output
