// Reading a whole file that somebody else wrote.
#pragma once

#include <filesystem>
#include <string>

namespace spindrift::output {

/// Throws where a path does not name a regular file that can be read: a missing file, a folder, a
/// pipe (FIFO), a socket or a device. Never waits for a writer, as opening a pipe would.
/// @throws std::runtime_error with the path and the reason
void require_regular_file(const std::filesystem::path& file);

/// The bytes of a regular file.
/// @throws std::runtime_error as require_regular_file, or where reading fails
std::string read_file(const std::filesystem::path& file);

}  // namespace spindrift::output
