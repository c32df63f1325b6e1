// Reads whole files that somebody else wrote.
#pragma once

#include <filesystem>
#include <string>

namespace spindrift::output {

/// Throws unless a path names a regular file that can be read: for a missing file, a folder, a pipe
/// (FIFO), a socket or a device. It never waits for a writer, as opening a pipe would.
/// @throws std::runtime_error with the path and the reason
void require_regular_file(const std::filesystem::path& file);

/// Returns the bytes of a regular file.
/// @throws std::runtime_error as require_regular_file() does, and where reading fails
std::string read_file(const std::filesystem::path& file);

}  // namespace spindrift::output
