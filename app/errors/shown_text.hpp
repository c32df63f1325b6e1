// Text that somebody else wrote, volumes and vectors, as they are shown in a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/geometry/vector_text.hpp"

namespace spindrift::app {

/// The text on one line and safe for a terminal: control characters, those that change the
/// direction or the place of letters (such as U+202E), and bytes that are no UTF-8 stand as \n,
/// \u001b, \xff.
std::string escaped(std::string_view text);

/// The same, cut to so many letters, the dots at its end included.
std::string shown(std::string_view text, std::size_t most_letters = 40);

/// A volume, m³, in litres with three digits that count.
std::string litres_text(double volume);

using geometry::vector_text;

/// Whether a text holds a character that `escaped` would replace.
bool holds_control_characters(std::string_view text);

}  // namespace spindrift::app
