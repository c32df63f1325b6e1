// The memory and disk space that the machine has and a process takes, and errors that come from
// having too little.
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>

namespace spindrift::app {

/// The most memory that this process can have, bytes: the least of the machine's memory, the
/// container's limit (control group) and the process's limit of address space.
std::uint64_t most_memory();

/// Nine tenths of the memory that is free now, and of most_memory() where that is less, bytes.
std::uint64_t free_memory();

/// The largest resident size, bytes, that this program alone has had.
std::uint64_t peak_memory();

/// The free space, bytes, on the disk of a folder, which need not exist yet.
std::uint64_t free_disk(const std::filesystem::path& folder);

/// A number of bytes as text, such as "1.5 GB".
std::string bytes_text(double bytes);

/// The error that stopped a command, in words; memory that ran out is described with its limit.
std::string reason_of(const std::exception& error);

}  // namespace spindrift::app
