// What this process can get no more of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace spindrift {

/// Tries whether the system still gives memory, a thread and open files, which libraries seldom say
/// when they fail for want of them.
/// @param bytes how much address space is wanted
/// @returns what there is too little of, with the limit that it comes from, as one sentence without
/// a
///          full stop; none: there is enough of all
std::optional<std::string> shortage(std::size_t bytes = std::size_t{64} << 20);

}  // namespace spindrift
