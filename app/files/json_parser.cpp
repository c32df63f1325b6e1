#include "app/files/json_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "app/errors/shown_text.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t longest_key = 60;             // characters of a key in a message
constexpr std::size_t longest_parser_reason = 200;  // characters of the parser's own message

/// Iterator over text that counts the characters it has passed in a variable outside it, where they
/// can be read while the parser holds the iterator.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::size_t* consumed;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*consumed;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

/// Goes through the text once, from token to token, and counts lines and characters on its way.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf"))  // a byte order mark takes no column
      offset_ = 3;
  }

  TextPosition position() const { return position_; }

  void go_to(std::size_t offset) {
    for (; offset_ < std::min(offset, text_.size()); ++offset_) {
      const auto c = static_cast<unsigned char>(text_[offset_]);
      if (c == '\n')
        position_ = {position_.line + 1, 1};
      else if ((c & 0xc0) != 0x80)  // the further bytes of a UTF-8 character do not count
        ++position_.column;
    }
  }

  /// Passes spaces, commas, colons and comments up to the next token.
  void go_to_next_token() {
    for (;;) {
      const std::size_t next = text_.find_first_not_of(" \t\r\n,:", offset_);
      go_to(next);
      const std::string_view rest = text_.substr(offset_);
      if (rest.starts_with("//"))
        go_to(text_.find_first_of("\r\n", offset_));
      else if (rest.starts_with("/*"))
        go_to(end_of_comment());
      else
        return;
    }
  }

  /// Goes to the end of the number that begins here. The parser's own position is no use: it has
  /// looked one character further.
  void go_over_number() { go_to(text_.find_first_not_of("+-.0123456789eE", offset_)); }

 private:
  std::size_t end_of_comment() const {
    const std::size_t end = text_.find("*/", offset_ + 2);
    return end == std::string_view::npos ? end : end + 2;
  }

  std::string_view text_;
  std::size_t offset_ = 0;
  TextPosition position_{1, 1};
};

/// A message from the parser's own text, without the parser's names and position, such as
/// "not valid JSON: unexpected '}'; expected …".
std::string syntax_error(std::string_view what) {
  const auto at = what.find(" - ");
  return "not valid JSON: " +
         shown(at == std::string_view::npos ? what : what.substr(at + 3), longest_parser_reason);
}

/// Takes the parser's events and builds the document with its positions.
class DocumentBuilder : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(std::string_view text, const std::size_t& consumed, ParsedJson& into)
      : cursor_(text), consumed_(consumed), into_(into) {}

  bool null() override { return put_word(nullptr); }
  bool boolean(bool value) override { return put_word(value); }
  bool number_integer(number_integer_t value) override { return put_number(value); }
  bool number_unsigned(number_unsigned_t value) override { return put_number(value); }
  bool number_float(number_float_t value, const string_t&) override { return put_number(value); }
  bool string(string_t& value) override { return put_word(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // JSON text has no binary values
  bool start_object(std::size_t) override { return start(Json::object()); }
  bool start_array(std::size_t) override { return start(Json::array()); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }

  bool key(string_t& name) override {
    cursor_.go_to_next_token();
    refuse_second(name);
    Open& open = open_.back();
    open.json->get_ref<Json::object_t&>().emplace_back(name, Json());
    open.positions->parts.push_back({cursor_.position(), {}});
    cursor_.go_to(consumed_);
    return true;
  }

  bool parse_error(std::size_t letters_read, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      cursor_.go_to_next_token();
      refuse(fmt::format("{} is too large for a number; at most about 1.8e308 is accepted",
                         shown(token)));
    }
    cursor_.go_to(letters_read == 0 ? 0 : letters_read - 1);
    throw JsonError(JsonError::not_json, cursor_.position(), syntax_error(error.what()));
  }

 private:
  /// A list or an object whose end is still to come.
  struct Open {
    Json* json;
    JsonPositions* positions;
    std::map<std::string, std::size_t> keys = {};  ///< index of each key; used from `few` keys on
  };

  [[noreturn]] void refuse(const std::string& message) const {
    throw JsonError(JsonError::refused, cursor_.position(), message);
  }

  void refuse_second(const std::string& name) {
    constexpr std::size_t few = 16;  // fewer keys are searched one by one
    Open& open = open_.back();
    const auto& members = open.json->get_ref<const Json::object_t&>();
    std::size_t first = members.size();
    if (members.size() < few) {
      first = static_cast<std::size_t>(
          std::find_if(members.begin(), members.end(),
                       [&](const auto& member) { return member.first == name; }) -
          members.begin());
    } else {
      for (std::size_t k = open.keys.size(); k < members.size(); ++k)
        open.keys.emplace(members.begin()[k].first, k);
      if (const auto found = open.keys.find(name); found != open.keys.end())
        first = found->second;
    }
    if (first == members.size())
      return;
    const TextPosition before = open.positions->parts[first].at;
    refuse(fmt::format("\"{}\" is given twice; the first is at line {}, column {}",
                       shown(name, longest_key), before.line, before.column));
  }

  /// Puts a value into the list or object that is open. The cursor is on the value's first
  /// character.
  Open put(Json value) {
    if (open_.empty()) {
      into_ = {std::move(value), {cursor_.position(), {}}};
      return {&into_.json, &into_.positions};
    }
    const Open& open = open_.back();
    if (open.json->is_object()) {  // the key has made an empty member for the value
      Json& member = open.json->get_ref<Json::object_t&>().back().second;
      member = std::move(value);
      return {&member, &open.positions->parts.back()};
    }
    auto& entries = open.json->get_ref<Json::array_t&>();
    entries.push_back(std::move(value));
    open.positions->parts.push_back({cursor_.position(), {}});
    return {&entries.back(), &open.positions->parts.back()};
  }

  template <class T>
  bool put_word(T value) {
    cursor_.go_to_next_token();
    put(Json(std::move(value)));
    cursor_.go_to(consumed_);
    return true;
  }

  template <class T>
  bool put_number(T value) {
    cursor_.go_to_next_token();
    put(Json(value));
    cursor_.go_over_number();
    return true;
  }

  bool start(Json empty) {
    cursor_.go_to_next_token();
    if (open_.size() == most_json_levels)
      refuse(fmt::format("nested too deep; at most {} levels of lists and objects are accepted",
                         most_json_levels));
    open_.push_back(put(std::move(empty)));
    cursor_.go_to(consumed_);
    return true;
  }

  bool end() {
    cursor_.go_to(consumed_);
    open_.pop_back();
    return true;
  }

  TextCursor cursor_;
  const std::size_t& consumed_;
  ParsedJson& into_;
  std::vector<Open> open_;
};

}  // namespace

ParsedJson parse_json(std::string_view text) {
  if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
    TextCursor cursor(text);
    cursor.go_to(nul);
    throw JsonError(JsonError::not_json, cursor.position(),
                    "not valid JSON: a NUL character; text in UTF-8 is expected");
  }
  std::size_t consumed = 0;
  ParsedJson parsed;
  DocumentBuilder builder(text, consumed, parsed);
  Json::sax_parse(CountingIterator{text.data(), &consumed},
                  CountingIterator{text.data() + text.size(), &consumed}, &builder,
                  Json::input_format_t::json, true, true);
  return parsed;
}

}  // namespace spindrift::app
