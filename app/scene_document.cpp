#include "app/scene_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <vector>

#include "app/scene.hpp"

namespace spindrift::app {
namespace {

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}", line, before.size() - line_start + 1);
}

/// Iterator over text that leaves behind how far it has come.
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

/// Listens to the parser and notes where each key and list entry begins.
class PlaceRecorder : public nlohmann::json_sax<Json> {
 public:
  PlaceRecorder(std::string_view text, const std::size_t& consumed, const std::string& source,
                std::map<std::string, std::string, std::less<>>& places)
      : text_(text), consumed_(consumed), source_(source), places_(places) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return start(false); }
  bool start_array(std::size_t) override { return start(true); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;  // reported by the parser that builds the document
  }

  bool key(string_t& name) override {
    const std::string path = child_path(open_.back().path, name);
    const std::size_t begin = text_.rfind('"', consumed_ - 2);
    const std::string place = place_at(begin);
    if (places_.contains(path)) {
      throw SceneError(fmt::format("{}: {} is given twice; the first is at {}", place, path,
                                   places_.find(path)->second));
    }
    places_.emplace(path, place);
    next_path_ = path;
    return true;
  }

 private:
  struct Open {
    std::string path;
    bool array;
    std::size_t count;
  };

  std::string place_at(std::size_t offset) const {
    return fmt::format("{}:{}", source_, line_and_column(text_, offset));
  }

  /// First letter of the token that ends before or just at the parser's position, which may be one
  /// letter beyond a number.
  std::size_t token_start() const {
    const auto in_token = [this](std::size_t i) {
      const auto c = static_cast<unsigned char>(text_[i]);
      return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
    };
    std::size_t i = consumed_ - 1;
    if (text_[i] == '"') {
      return text_.rfind('"', i - 1);
    }
    if (!in_token(i) && i > 0) {
      --i;
    }
    while (i > 0 && in_token(i) && in_token(i - 1)) {
      --i;
    }
    return i;
  }

  bool note_entry(std::size_t offset) {
    if (open_.empty()) {
      next_path_.clear();
      places_.emplace("", place_at(offset));
    } else if (open_.back().array) {
      next_path_ = child_path(open_.back().path, open_.back().count++);
      places_.emplace(next_path_, place_at(offset));
    }
    return true;
  }
  bool value() { return note_entry(token_start()); }
  bool start(bool array) {
    note_entry(consumed_ - 1);
    open_.push_back({next_path_, array, 0});
    return true;
  }
  bool end() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::size_t& consumed_;
  const std::string& source_;
  std::map<std::string, std::string, std::less<>>& places_;
  std::vector<Open> open_;
  std::string next_path_;
};

/// The parser's reason without its own names and position: "unexpected '}'; expected …".
std::string reason_of(const nlohmann::json::parse_error& error) {
  const std::string_view what = error.what();
  const auto at = what.find(" - ");
  return fmt::format("not valid JSON: {}", at == what.npos ? what : what.substr(at + 3));
}

/// "fluid.volumes[0].velocity" as fluid, volumes, 0, velocity.
std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.' || c == '[') {
      parts.emplace_back();
    } else if (c != ']') {
      parts.back() += c;
    }
  }
  return parts;
}

bool is_index(const std::string& part) {
  return !part.empty() && part.size() < 9 &&
         std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c); });
}

}  // namespace

std::string child_path(std::string_view parent, std::string_view key) {
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string child_path(std::string_view parent, std::size_t index) {
  return fmt::format("{}[{}]", parent, index);
}

SceneDocument::SceneDocument(std::string_view text, std::string source)
    : source_(std::move(source)) {
  try {
    root_ = Json::parse(text.begin(), text.end(), nullptr, true, true);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
    throw SceneError(
        fmt::format("{}:{}: {}", source_, line_and_column(text, offset), reason_of(error)));
  } catch (const nlohmann::json::out_of_range& error) {
    throw SceneError(fmt::format("{}: a number is too large: {}", source_, error.what()));
  }
  std::size_t consumed = 0;
  PlaceRecorder recorder(text, consumed, source_, places_);
  Json::sax_parse(CountingIterator{text.data(), &consumed},
                  CountingIterator{text.data() + text.size(), &consumed}, &recorder,
                  Json::input_format_t::json, true, true);
}

namespace {

/// A key of one of the scene's sections, if it was typed without the section's name; else nothing.
std::string with_section(const std::string& key, const Json& defaults) {
  for (const auto& [section, values] : defaults.items()) {
    if (!defaults.contains(key) && values.is_object() && values.contains(key)) {
      return child_path(section, key);
    }
  }
  return {};
}

}  // namespace

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

void SceneDocument::override_value(const std::string& assignment, const Json& defaults) {
  const std::string place = "--set " + assignment;
  const auto equals = assignment.find('=');
  const std::string key = trimmed(assignment.substr(0, equals));
  if (equals == std::string::npos || key.empty()) {
    throw SceneError(
        fmt::format("{}: expected KEY=VALUE, as in --set fluid.viscosity=0.05", place));
  }
  if (const std::string full = with_section(key, defaults); !full.empty()) {
    throw SceneError(fmt::format("{}: {}: unknown key; did you mean \"{}\"?", place, key, full));
  }
  const std::string typed = trimmed(assignment.substr(equals + 1));
  Json value = Json::parse(typed, nullptr, false);
  if (value.is_discarded()) {
    value = typed;
  }

  Json* at = &root_;
  const Json* fallback = &defaults;  // the same place in the defaults, or none
  std::string path;
  for (const std::string& part : split_key(key)) {
    if (part.empty()) {
      throw SceneError(fmt::format("{}: a name is missing in the key", place));
    }
    if (at->is_array() && is_index(part)) {
      const std::size_t index = std::stoul(part);
      if (index > at->size()) {
        throw SceneError(fmt::format("{}: {} has {} entries; the next is [{}]", place, path,
                                     at->size(), at->size()));
      }
      if (index == at->size()) {
        at->push_back(Json());
      }
      fallback = nullptr;
      path = child_path(path, index);
      at = &(*at)[index];
    } else if (at->is_object() || at->is_null()) {
      const bool known = fallback && fallback->is_object() && fallback->contains(part);
      fallback = known ? &(*fallback)[part] : nullptr;
      const bool absent = !at->is_object() || !at->contains(part);
      path = child_path(path, part);
      at = &(*at)[part];
      if (absent && fallback && fallback->is_array()) {
        *at = *fallback;
      }
    } else {
      throw SceneError(fmt::format("{}: {} is {}, it has no \"{}\"", place, path,
                                   at->is_array() ? "a list" : "a single value", part));
    }
  }
  *at = std::move(value);
  std::erase_if(places_, [&](const auto& entry) {
    return entry.first.starts_with(path + ".") || entry.first.starts_with(path + "[");
  });
  places_[path] = place;
  overridden_.push_back(path);
}

std::string SceneDocument::place_of(std::string path) const {
  for (const std::string& changed : overridden_) {  // a part of the value is not the file's
    const bool within = changed.starts_with(path + ".") || changed.starts_with(path + "[");
    if (const auto found = places_.find(changed); within && found != places_.end()) {
      return found->second;
    }
  }
  for (;;) {
    if (const auto found = places_.find(path); found != places_.end()) {
      return found->second;
    }
    if (path.empty()) {
      return source_;
    }
    const auto cut = path.find_last_of(".[");
    path.resize(cut == std::string::npos ? 0 : cut);
  }
}

}  // namespace spindrift::app
