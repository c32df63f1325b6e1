// Finds out what the system gives this process no more of, to explain why a library has failed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace spindrift {

/// Tries whether the system still gives memory, a thread and an open file; libraries seldom say
/// that they fail for want of one of them.
/// @param bytes how much address space is wanted
/// @return what there is too little of, with the limit that it comes from, as one sentence without
/// a full stop; none where there is enough of all
std::optional<std::string> shortage(std::size_t bytes = std::size_t{64} << 20);

}  // namespace spindrift
