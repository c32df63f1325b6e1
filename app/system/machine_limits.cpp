#include "app/system/machine_limits.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <optional>

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// The bytes that a line such as "MemTotal:     16384 kB" of a file of /proc states; nothing where
/// there is no such line.
std::optional<std::uint64_t> kilobyte_line(const char* file, std::string_view name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(name))
      return std::stoull(line.substr(name.size())) * 1024;
  return std::nullopt;
}

/// The number of bytes that a file holds; UINT64_MAX where there is no file, or it holds a word.
std::uint64_t limit_in(const fs::path& file) {
  std::uint64_t bytes = 0;
  return std::ifstream(file) >> bytes ? bytes : UINT64_MAX;
}

/// The memory limit, bytes, of this process's control group and the groups above it (version 2), or
/// of version 1.
std::uint64_t control_group_limit() {
  std::uint64_t limit = std::min(limit_in("/sys/fs/cgroup/memory.max"),
                                 limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
  std::ifstream stream("/proc/self/cgroup");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("0::/"))
      for (fs::path group = line.substr(4); !group.empty(); group = group.parent_path())
        limit = std::min(limit, limit_in("/sys/fs/cgroup" / group / "memory.max"));
  return limit;
}

}  // namespace

std::uint64_t most_memory() {
  rlimit space{};
  std::uint64_t limit = UINT64_MAX;
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    limit = space.rlim_cur;
  const std::uint64_t machine = kilobyte_line("/proc/meminfo", "MemTotal:").value_or(UINT64_MAX);
  return std::min({limit, machine, control_group_limit()});
}

std::uint64_t free_memory() {
  const std::uint64_t free = kilobyte_line("/proc/meminfo", "MemAvailable:").value_or(UINT64_MAX);
  return std::min(free, most_memory()) / 10 * 9;
}

std::uint64_t peak_memory() {
  // VmHWM comes first because the figure of getrusage() counts what ran before exec() as well.
  if (const auto peak = kilobyte_line("/proc/self/status", "VmHWM:"))
    return *peak;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::uint64_t>(usage.ru_maxrss);
}

std::uint64_t free_disk(const fs::path& folder) {
  std::error_code ignored;
  fs::path there = fs::absolute(folder);
  while (!fs::exists(there, ignored) && there.has_relative_path())
    there = there.parent_path();
  const fs::space_info space = fs::space(there, ignored);
  return ignored ? UINT64_MAX : space.available;
}

std::string bytes_text(double bytes) {
  return bytes < 1e6   ? fmt::format("{:.0f} kB", bytes / 1e3)
         : bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                       : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string reason_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return fmt::format(
        "out of memory: the system gives this process no more of it (it may have {}); a larger "
        "fluid.spacing needs less",
        bytes_text(static_cast<double>(most_memory())));
  return error.what();
}

}  // namespace spindrift::app
