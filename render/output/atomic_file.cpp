#include "render/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>

namespace spindrift::output {
namespace {

constexpr std::size_t buffer_bytes = 256 * 1024;

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(error));
}

// Returns a name like ".video.1234-0.part.mp4". It is hidden from listings and globs, and keeps the
// extension, since libraries go by it. The process id and the attempt keep two writers of the same
// file apart.
std::filesystem::path temporary_for(const std::filesystem::path& file, int attempt) {
  constexpr std::size_t longest_stem = 128;  // bytes; leaves room below the usual limit of 255
  std::string name = ".";
  name += file.stem().string().substr(0, longest_stem);
  name += '.';
  name += std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".part";
  name += file.extension().string();
  return file.parent_path() / name;
}

// Returns whether a name is one that temporary_for() gives.
bool is_part(const std::string& name) {
  static const std::regex pattern(R"(\..*\.[0-9]+-[0-9]+\.part(\.[^.]*)?)");
  return std::regex_match(name, pattern);
}

}  // namespace

// A name is refused before anything is rendered, rather than when the file is to be renamed. A
// device such as /dev/null must not be replaced by a file.
void require_replaceable(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (!file.has_filename() || std::filesystem::is_directory(status))
    fail(file, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw std::runtime_error("cannot write " + file.string() +
                             ": a file that is not a regular one has this name");
  }
}

void give_name(const std::filesystem::path& part, const std::filesystem::path& file) {
  if (::rename(part.c_str(), file.c_str()) != 0) {
    const int error = errno;
    ::unlink(part.c_str());
    fail(file, error);
  }
}

void make_folders(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error)
    return;
  std::filesystem::path part;
  for (const std::filesystem::path& name : folder) {
    part /= name;
    std::error_code ignored;
    const auto status = std::filesystem::status(part, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_directory(status))
      throw std::runtime_error("cannot make the folder " + folder.string() + ": " + part.string() +
                               " is a file");
  }
  throw std::runtime_error("cannot make the folder " + folder.string() + ": " + error.message());
}

std::filesystem::path part_name(const std::filesystem::path& file) {
  return temporary_for(file, 0);
}

void remove_part_files(const std::filesystem::path& folder) {
  std::error_code none;  // a folder that isn't there has no files
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (is_part(entry.path().filename().string()) &&
        entry.symlink_status().type() == std::filesystem::file_type::regular)
      std::filesystem::remove(entry.path());
}

AtomicFile::AtomicFile(std::filesystem::path file) : file_(std::move(file)) {
  require_replaceable(file_);
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = temporary_for(file_, attempt);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST && errno != EINTR)
      fail(file_, errno);
  }
}

AtomicFile::~AtomicFile() {
  close_and_remove();
}

void AtomicFile::close_and_remove() noexcept {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
    descriptor_ = -1;
  }
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  if (descriptor_ < 0)
    throw std::logic_error("AtomicFile: write after commit");
  if (buffer_.size() + bytes.size() > buffer_bytes) {
    flush();
    if (bytes.size() >= buffer_bytes) {
      put(bytes);
      return;
    }
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

void AtomicFile::flush() {
  put(buffer_);
  buffer_.clear();
}

void AtomicFile::put(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
      fail(file_, errno);
    if (written > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  if (descriptor_ < 0)
    throw std::logic_error("AtomicFile: second commit");
  flush();
  // Some file systems report a full disk only here.
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    const int error = errno;
    ::unlink(temporary_.c_str());
    fail(file_, error);
  }
  give_name(temporary_, file_);
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  AtomicFile output(file);
  output.write(text);
  output.commit();
}

}  // namespace spindrift::output
