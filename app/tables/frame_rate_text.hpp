// Converts frame rates from and to the forms that scene files have: a number, or a fraction as
// text.
#pragma once

#include <optional>
#include <string>

#include "render/frame_rate.hpp"

namespace spindrift::app {

/// The rate as text, such as "30" or "30000/1001".
std::string rate_text(const FrameRate& rate);

/// The rate that a text such as "30" or "30000/1001" names; none for other texts.
std::optional<FrameRate> rate_of(const std::string& text);

/// The rate that is exactly a number of thousandths, such as 30 or 23.976; none for other numbers.
std::optional<FrameRate> rate_of(double number);

}  // namespace spindrift::app
