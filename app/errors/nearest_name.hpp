// Finds the accepted name that is most like a mistyped one, for hints in error messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace spindrift::app {

/// Damerau-Levenshtein distance (optimal string alignment): the number of letters inserted, left
/// out, replaced, or swapped with their neighbour.
int edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `typed`. It is empty when no name is within a third of the typed letters
/// plus one.
std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> names);

/// "did you mean "X"?", or "accepted: " and all names when none is like the one typed.
std::string suggestion(std::string_view typed, std::span<const std::string_view> names);

}  // namespace spindrift::app
