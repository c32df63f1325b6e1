// What the machine has room for.
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>

namespace spindrift::app {

/// Memory that this process can have at the very most, bytes: the machine's, a container's (control
/// group), or its limit of address space.
std::uint64_t most_memory();

/// Memory that is free now, less a tenth, and no more than most_memory(), bytes.
std::uint64_t free_memory();

/// Room on the disk of a folder, which need not be there yet, bytes.
std::uint64_t free_disk(const std::filesystem::path& folder);

/// "1.5 GB".
std::string bytes_text(double bytes);

/// What stopped a command, in words, also where the machine has no more of something.
std::string reason_of(const std::exception& error);

}  // namespace spindrift::app
