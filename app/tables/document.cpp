#include "app/tables/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/errors/shown_text.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t longest_part = 60;  // characters of a key in a path

/// Splits "fluid.volumes[0].velocity" into fluid, volumes, 0 and velocity.
std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts(1);
  for (const char c : key)
    if (c == '.' || c == '[')
      parts.emplace_back();
    else if (c != ']')
      parts.back() += c;
  return parts;
}

bool is_index(const std::string& part) {
  return !part.empty() && part.size() < 9 &&
         std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// The full path, such as fluid.spacing, of a section's key that was typed without the section's
/// name; empty for other keys.
std::string with_section(const std::string& key, const Json& defaults) {
  for (const auto& [section, values] : defaults.items())
    if (!defaults.contains(key) && values.is_object() && values.contains(key))
      return child_path(section, key);
  return {};
}

/// The index of a key in an object; the object's size where it has no such key.
std::size_t number_of(const Json& object, std::string_view key) {
  const auto& members = object.get_ref<const Json::object_t&>();
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const auto& member) { return member.first == key; });
  return static_cast<std::size_t>(found - members.begin());
}

/// Descends into a document along the key of an override, and creates what does not exist yet.
class OverridePath {
 public:
  /// @param at the position that is given to the values that the override changes
  OverridePath(ParsedJson& document, const Json& defaults, const Place& place, TextPosition at)
      : json_(&document.json),
        positions_(&document.positions),
        fallback_(&defaults),
        place_(place),
        at_(at) {}

  void go_to(const std::string& part) {
    if (part.empty())
      fail("a name is missing in the key");
    if (!path_.empty() && positions_->at.line != 0)
      positions_->at = at_;  // a value with a changed part is no longer from the file alone
    if (json_->is_array() && is_index(part)) {
      go_to_entry(std::stoul(part));
    } else if (json_->is_object() || json_->is_null()) {
      go_to_member(part);
    } else {
      fail(fmt::format("{} is {}, it has no \"{}\"", path_,
                       json_->is_array() ? "a list" : "a single value", shown(part)));
    }
  }

  void set(Json value) {
    *json_ = std::move(value);
    *positions_ = {at_, {}};
  }

 private:
  [[noreturn]] void fail(std::string message) const {
    throw SceneError(Problem{place_, {}, std::move(message)});
  }

  void go_to_entry(std::size_t index) {
    if (index > json_->size())
      fail(fmt::format("{} has {} entries; the next is [{}]", path_, json_->size(), json_->size()));
    if (index == json_->size())
      json_->push_back(Json());
    fallback_ = nullptr;
    path_ = child_path(path_, index);
    json_ = &(*json_)[index];
    go_to_positions(index);
  }

  void go_to_member(const std::string& key) {
    const bool known = fallback_ && fallback_->is_object() && fallback_->contains(key);
    fallback_ = known ? &(*fallback_)[key] : nullptr;
    const bool absent = !json_->is_object() || !json_->contains(key);
    Json& member = (*json_)[key];
    go_to_positions(number_of(*json_, key));
    path_ = child_path(path_, key);
    json_ = &member;
    if (absent && fallback_ && fallback_->is_array())
      *json_ = *fallback_;
  }

  void go_to_positions(std::size_t k) {
    auto& parts = positions_->parts;
    if (parts.size() <= k)
      parts.resize(k + 1, JsonPositions{positions_->at, {}});
    positions_ = &parts[k];
  }

  Json* json_;
  JsonPositions* positions_;
  const Json* fallback_;  // the value under the same key in the defaults, or null
  const Place& place_;
  TextPosition at_;
  std::string path_;
};

}  // namespace

std::string child_path(std::string_view parent, std::string_view key) {
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string child_path(std::string_view parent, std::size_t index) {
  return fmt::format("{}[{}]", parent, index);
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Json typed_value(const std::string& typed, const Place& place) {
  try {
    return parse_json(typed).json;
  } catch (const JsonError& error) {
    if (error.kind() == JsonError::refused)
      throw SceneError(Problem{place, {}, error.what()});
    return typed;
  }
}

SceneDocument::SceneDocument(std::string_view text, std::string source)
    : source_(std::move(source)) {
  try {
    parsed_ = parse_json(text);
  } catch (const JsonError& error) {
    throw SceneError(Problem{place(error.at()), {}, error.what()});
  }
}

void SceneDocument::override_value(const std::string& assignment, const Json& defaults) {
  const auto number = static_cast<std::uint32_t>(overrides_.size());
  overrides_.push_back("--set " + assignment);
  const Place place{overrides_.back()};
  const auto fail = [&](std::string path, std::string message) {
    throw SceneError(Problem{place, std::move(path), std::move(message)});
  };
  const auto equals = assignment.find('=');
  const std::string key = trimmed(assignment.substr(0, equals));
  if (equals == std::string::npos || key.empty())
    fail("", "expected KEY=VALUE, as in --set fluid.viscosity=0.05");
  if (const std::string full = with_section(key, defaults); !full.empty())
    fail(key, fmt::format("unknown key; did you mean \"{}\"?", full));
  const std::vector<std::string> parts = split_key(key);
  if (parts.size() > most_json_levels)
    fail(key, fmt::format("nested too deep; at most {} levels are accepted", most_json_levels));
  Json value = typed_value(trimmed(assignment.substr(equals + 1)), place);
  OverridePath at(parsed_, defaults, place, {0, number});
  for (const std::string& part : parts)
    at.go_to(part);
  at.set(std::move(value));
}

Place SceneDocument::place(TextPosition at) const {
  return at.line == 0 ? Place{overrides_[at.column]} : Place{source_, at.line, at.column};
}

LocatedValue SceneDocument::value() const {
  return {*this, parsed_.json, parsed_.positions.at, &parsed_.positions};
}

Problem SceneDocument::problem(std::string path, std::string message) const {
  const Json* json = &parsed_.json;
  const JsonPositions* positions = &parsed_.positions;
  if (!path.empty()) {
    for (const std::string& part : split_key(path)) {
      const std::size_t k = json->is_object()                    ? number_of(*json, part)
                            : json->is_array() && is_index(part) ? std::stoul(part)
                                                                 : json->size();
      if (k >= json->size() || k >= positions->parts.size())
        break;
      json = json->is_object() ? &json->get_ref<const Json::object_t&>().begin()[k].second
                               : &(*json)[k];
      positions = &positions->parts[k];
    }
  }
  return {place(positions->at), std::move(path), std::move(message)};
}

LocatedValue LocatedValue::part(const Json& json, std::size_t k, std::string_view key) const {
  const bool known = positions_ && k < positions_->parts.size();
  const JsonPositions* positions = known ? &positions_->parts[k] : nullptr;
  return {*document_, json, known ? positions->at : at_, positions, this, key, k};
}

LocatedValue LocatedValue::operator[](std::size_t index) const {
  return part((*json_)[index], index, {});
}

LocatedValue LocatedValue::member(std::size_t k) const {
  const auto& [key, value] = json_->get_ref<const Json::object_t&>().begin()[k];
  return part(value, k, key);
}

std::optional<LocatedValue> LocatedValue::find(std::string_view key) const {
  const std::size_t k = number_of(*json_, key);
  if (k == json_->size())
    return std::nullopt;
  return member(k);
}

std::string LocatedValue::path() const {
  if (is_root())
    return {};
  return parent_->json_->is_array() ? child_path(parent_->path(), index_)
                                    : child_path(parent_->path(), shown(key_, longest_part));
}

std::string LocatedValue::place_and_path() const {
  return fmt::format("{}: {}", document_->place(at_).text(), path());
}

Problem LocatedValue::problem(std::string message) const {
  return {document_->place(at_), path(), std::move(message)};
}

}  // namespace spindrift::app
