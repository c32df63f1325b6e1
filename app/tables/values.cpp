#include "app/tables/values.hpp"

#include <charconv>

#include "app/tables/frame_rate_text.hpp"

namespace spindrift::app {
namespace {

/// A value on one line with spaces as people write it: {"min": [0, 1, 2]}.
std::string one_line(const Json& json) {
  const std::string dense = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  bool quoted = false;
  for (std::size_t i = 0; i < dense.size(); ++i) {
    text += dense[i];
    if (quoted && dense[i] == '\\')
      text += dense[++i];
    else if (dense[i] == '"')
      quoted = !quoted;
    else if (!quoted && (dense[i] == ',' || dense[i] == ':'))
      text += ' ';
  }
  return text;
}

/// Appends a value to `out`, on one line where it fits and else with each entry on its own line.
/// @param key_width characters that stand before the value on its line, after the indent
void write_text(const Json& json, std::size_t indent, std::size_t key_width, std::string& out);

void write_entry(const std::string& name, const Json& value, std::size_t indent, std::string& out) {
  out += std::string(indent, ' ') + name;
  write_text(value, indent, name.size(), out);
}

void write_text(const Json& json, std::size_t indent, std::size_t key_width, std::string& out) {
  constexpr std::size_t line_width = 100;
  // Every entry takes at least two characters, so a long list is known not to fit without being
  // written out.
  if (!json.is_structured() || (indent > 0 && 2 * json.size() < line_width)) {
    const std::string flat = one_line(json);
    if (!json.is_structured() || indent + key_width + flat.size() < line_width) {
      out += flat;
      return;
    }
  }
  out += json.is_array() ? "[" : "{";
  const char* separator = "\n";
  if (json.is_array()) {
    for (const Json& entry : json) {
      out += separator;
      write_entry("", entry, indent + 2, out);
      separator = ",\n";
    }
  } else {
    for (const auto& [key, value] : json.items()) {
      out += separator;
      write_entry(one_line(key) + ": ", value, indent + 2, out);
      separator = ",\n";
    }
  }
  out += "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace

Json json_of(float value) {
  char text[64];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double read = 0.;
  std::from_chars(text, written.ptr, read);
  return read == 0. ? 0. : read;  // turns −0 into 0
}

Json json_of(const glm::vec3& value) {
  return Json::array({json_of(value.x), json_of(value.y), json_of(value.z)});
}

Json json_of(const FrameRate& value) {
  return value.denominator == 1 ? Json(value.numerator) : Json(rate_text(value));
}

std::string to_text(const Json& json) {
  std::string out;
  write_text(json, 0, 0, out);
  return out + "\n";
}

}  // namespace spindrift::app
