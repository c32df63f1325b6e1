// The valid name most like a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace spindrift::app {

/// Damerau-Levenshtein distance (optimal string alignment): letters inserted, left out, replaced,
/// or two neighbours swapped.
int edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `typed`, or an empty one when none is like it.
std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> names);

/// "did you mean X?", or the list of all names when none is like the one typed.
std::string suggestion(std::string_view typed, std::span<const std::string_view> names);

}  // namespace spindrift::app
