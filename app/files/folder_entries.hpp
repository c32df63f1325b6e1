// What is in a folder in which others may be at work.
#pragma once

#include <filesystem>
#include <vector>

namespace spindrift::app {

/// The entries of a folder; what goes away meanwhile, or may not be read, is passed over.
std::vector<std::filesystem::directory_entry> entries_in(const std::filesystem::path& folder);

/// The same with those of all folders below; symbolic links are not followed.
std::vector<std::filesystem::directory_entry> entries_below(const std::filesystem::path& folder);

}  // namespace spindrift::app
