// Lists folders in which other processes may be adding and removing files.
#pragma once

#include <filesystem>
#include <vector>

namespace spindrift::app {

/// The entries of a folder. Entries that vanish meanwhile or may not be read are left out.
std::vector<std::filesystem::directory_entry> entries_in(const std::filesystem::path& folder);

/// The entries of a folder and of all folders below it, as by entries_in. Symbolic links are not
/// followed.
std::vector<std::filesystem::directory_entry> entries_below(const std::filesystem::path& folder);

}  // namespace spindrift::app
