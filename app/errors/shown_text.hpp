// Turns user-written text, volumes and vectors into the form in which messages show them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/geometry/vector_text.hpp"

namespace spindrift::app {

/// Puts the text on one line that is safe for a terminal: control characters, characters that
/// change the direction or the place of letters (such as U+202E), and bytes that are not UTF-8 are
/// written as escapes such as \n, \u001b and \xff.
std::string escaped(std::string_view text);

/// The escaped text, cut to `most_letters` characters including the three dots at the cut.
std::string shown(std::string_view text, std::size_t most_letters = 40);

/// A volume, m³, as a number of litres with three significant digits.
std::string litres_text(double volume);

using geometry::vector_text;

/// Whether a text contains a character or byte that `escaped` would replace.
bool holds_control_characters(std::string_view text);

}  // namespace spindrift::app
