// Parses JSON text, in one pass, into a document with the line and column of everything in it.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::app {

using Json = nlohmann::ordered_json;

/// The deepest nesting of lists and objects that is accepted. Functions that work on a parsed
/// document may therefore recurse once per level.
inline constexpr std::size_t most_json_levels = 64;

struct TextPosition {
  std::uint32_t line = 0;    ///< counted from 1
  std::uint32_t column = 0;  ///< in characters, counted from 1
};

/// The position of a value in the text, and those of its parts.
struct JsonPositions {
  TextPosition at;                   ///< of an object's member: where its key begins
  std::vector<JsonPositions> parts;  ///< a list's entries or an object's members, in their order
};

/// A document and the positions of its values, which form a tree of the same structure.
struct ParsedJson {
  Json json;
  JsonPositions positions;
};

/// Thrown for a text that is not JSON, or is JSON that this parser does not accept.
class JsonError : public std::runtime_error {
 public:
  /// Whether the text is not JSON, or is JSON beyond this parser's limits.
  enum Kind { not_json, refused };
  JsonError(Kind kind, TextPosition at, const std::string& message)
      : std::runtime_error(message), kind_(kind), at_(at) {}
  Kind kind() const { return kind_; }
  TextPosition at() const { return at_; }

 private:
  Kind kind_;
  TextPosition at_;
};

/// Parses JSON (RFC 8259) with // and /* */ comments, in time and memory proportional to its
/// length.
/// @throws JsonError for what is not JSON, for a key given twice, a number beyond a double's range,
/// a NUL character, and more than most_json_levels levels
ParsedJson parse_json(std::string_view text);

}  // namespace spindrift::app
