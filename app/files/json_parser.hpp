// JSON text into a document, with the place of everything in it, in one pass.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::app {

using Json = nlohmann::ordered_json;

/// Lists and objects within each other, at most. What follows may call itself for each level.
inline constexpr std::size_t most_json_levels = 64;

struct TextPosition {
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< letters, from 1
};

/// Where a value was written, and its parts, in their order; an object's part is where its key is.
struct JsonPositions {
  TextPosition at;
  std::vector<JsonPositions> parts;
};

struct ParsedJson {
  Json json;
  JsonPositions positions;
};

/// A text that can't be read as JSON, or that is beyond what is accepted here.
class JsonError : public std::runtime_error {
 public:
  enum Kind { not_json, refused };
  JsonError(Kind kind, TextPosition at, const std::string& message)
      : std::runtime_error(message), kind_(kind), at_(at) {}
  Kind kind() const { return kind_; }
  TextPosition at() const { return at_; }

 private:
  Kind kind_;
  TextPosition at_;
};

/// Reads JSON (RFC 8259) with comments, // and /* */, in time and memory proportional to its
/// length. @throws JsonError for what is not JSON, for a key given twice, a number beyond a
/// double's range, a NUL character, and more than most_json_levels levels
ParsedJson parse_json(std::string_view text);

}  // namespace spindrift::app
