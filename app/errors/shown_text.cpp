#include "app/errors/shown_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace spindrift::app {
namespace {

/// One character of a text.
struct Character {
  std::string_view bytes;
  std::uint32_t number = 0;  ///< Unicode code point; 0 where the bytes are not UTF-8
  bool valid = true;         ///< whether the bytes are UTF-8
};

/// Decodes the UTF-8 character that a text begins with (RFC 3629).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const Character invalid{text.substr(0, 1), 0, false};
  const std::size_t length = byte(0) < 0x80             ? 1
                             : (byte(0) & 0xe0) == 0xc0 ? 2
                             : (byte(0) & 0xf0) == 0xe0 ? 3
                             : (byte(0) & 0xf8) == 0xf0 ? 4
                                                        : 0;
  if (length == 0 || text.size() < length)
    return invalid;
  std::uint32_t number = length == 1 ? byte(0) : byte(0) & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80)
      return invalid;
    number = number << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = 0xd800 <= number && number <= 0xdfff;
  if (number < least[length] || number > 0x10ffff || surrogate)
    return invalid;
  return {text.substr(0, length), number, true};
}

bool is_control(std::uint32_t number) {
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 6> ranges{{{0, 0x1f},
                                                                           {0x7f, 0x9f},
                                                                           {0x200b, 0x200f},
                                                                           {0x2028, 0x202e},
                                                                           {0x2060, 0x206f},
                                                                           {0xfeff, 0xfeff}}};
  return std::any_of(ranges.begin(), ranges.end(), [&](const auto& range) {
    return range.first <= number && number <= range.second;
  });
}

std::string shown_character(const Character& c) {
  if (!c.valid)
    return fmt::format("\\x{:02x}", static_cast<unsigned char>(c.bytes[0]));
  if (!is_control(c.number))
    return std::string(c.bytes);
  return c.number == '\n'   ? "\\n"
         : c.number == '\t' ? "\\t"
         : c.number == '\r' ? "\\r"
                            : fmt::format("\\u{:04x}", c.number);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character c = first_character(text);
    result += shown_character(c);
    text.remove_prefix(c.bytes.size());
  }
  return result;
}

std::string shown(std::string_view text, std::size_t most_letters) {
  std::string result;
  std::size_t letters = 0, cut = 0;  // the text ends at `cut` if dots must follow
  while (!text.empty()) {
    const Character c = first_character(text);
    const std::string one = shown_character(c);
    letters += one.size() == c.bytes.size() ? 1 : one.size();
    if (letters > most_letters)
      return result.substr(0, cut) + "...";
    result += one;
    if (letters + 3 <= most_letters)
      cut = result.size();
    text.remove_prefix(c.bytes.size());
  }
  return result;
}

bool holds_control_characters(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    if (!c.valid || is_control(c.number))
      return true;
    text.remove_prefix(c.bytes.size());
  }
  return false;
}

std::string litres_text(double volume) {
  const double litres = 1000. * volume;
  if (!(litres >= 999.5) || litres >= 1e6)
    return fmt::format("{:.3g}", litres);
  const double unit = litres < 1e4 ? 10. : litres < 1e5 ? 100. : 1000.;
  return fmt::format("{:.0f}", std::round(litres / unit) * unit);
}

}  // namespace spindrift::app
