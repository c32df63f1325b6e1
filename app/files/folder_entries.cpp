#include "app/files/folder_entries.hpp"

namespace spindrift::app {

namespace fs = std::filesystem;

std::vector<fs::directory_entry> entries_in(const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code gone;
  for (fs::directory_iterator next(folder, gone), end; !gone && next != end; next.increment(gone))
    entries.push_back(*next);
  return entries;
}

std::vector<fs::directory_entry> entries_below(const fs::path& folder) {
  std::vector<fs::directory_entry> entries = entries_in(folder);
  for (std::size_t k = 0; k < entries.size(); ++k) {  // the body appends entries
    std::error_code gone;
    if (entries[k].symlink_status(gone).type() != fs::file_type::directory)
      continue;
    const auto below = entries_in(entries[k].path());
    entries.insert(entries.end(), below.begin(), below.end());
  }
  return entries;
}

}  // namespace spindrift::app
