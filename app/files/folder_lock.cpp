#include "app/files/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "app/files/json_file.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// This process's command line, its words separated by spaces.
std::string own_command() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::string words{std::istreambuf_iterator<char>(stream), {}};
  while (!words.empty() && words.back() == '\0')
    words.pop_back();
  for (char& c : words)
    if (c == '\0')
      c = ' ';
  return words;
}

/// Writes into the lock's file which process holds the lock. A failure to write is ignored, since
/// the text only informs people.
void sign(int descriptor) {
  const std::string text =
      nlohmann::ordered_json{
          {"process", ::getpid()},
          {"command", own_command()},
          {"since", fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::time(nullptr)))}}
          .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
      "\n";
  if (::ftruncate(descriptor, 0) == 0 &&
      ::pwrite(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    (void)::ftruncate(descriptor, 0);
}

/// The JSON in a lock's file that describes the holder; null where none appears within a second.
/// A process that has just got the lock has not written it yet.
nlohmann::ordered_json signature_in(const fs::path& file) {
  using namespace std::chrono_literals;
  nlohmann::ordered_json who = json_in(file);
  for (int k = 0; k < 50 && who.is_null(); ++k) {
    std::this_thread::sleep_for(20ms);
    who = json_in(file);
  }
  return who;
}

/// A sentence about the process that holds a lock, from the lock's file.
std::string holder(const fs::path& file) {
  const nlohmann::ordered_json who = signature_in(file);
  try {
    return fmt::format("`{}` (process {}) has been at work here since {}",
                       who.at("command").get<std::string>(), who.at("process").get<int>(),
                       who.at("since").get<std::string>());
  } catch (const nlohmann::json::exception&) {
    return "another process is at work here";
  }
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, bool wait) {
  output::make_folders(folder);
  const fs::path file = folder / ".lock";
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor_ < 0)
    throw std::runtime_error(fmt::format("cannot write {}: {}", file.string(), strerror(errno)));
  int result = 0;
  do
    result = ::flock(descriptor_, LOCK_EX | (wait ? 0 : LOCK_NB));
  while (result != 0 && errno == EINTR);
  if (result == 0) {
    sign(descriptor_);
    output::remove_part_files(folder);
    return;
  }
  const int error = errno;
  ::close(descriptor_);
  throw std::runtime_error(error == EWOULDBLOCK
                               ? fmt::format("{}: {}; wait for it, or give another folder (-o)",
                                             folder.string(), holder(file))
                               : fmt::format("cannot lock {}: {}", file.string(), strerror(error)));
}

FolderLock::~FolderLock() {
  (void)!::ftruncate(descriptor_, 0);  // the next holder must not be taken for this one
  ::close(descriptor_);
}

}  // namespace spindrift::app
