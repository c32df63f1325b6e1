// A scene file as JSON, with overrides laid over it, that knows where each value was written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/errors/scene_error.hpp"
#include "app/files/json_parser.hpp"

namespace spindrift::app {

class LocatedValue;

class SceneDocument {
 public:
  /// @param source the file's name in messages
  /// @throws SceneError with file, line and column as parse_json does
  SceneDocument(std::string_view text, std::string source);

  /// Lays `KEY=VALUE` over the document. KEY is a path such as fluid.volumes[0].velocity or
  /// fluid.volumes.0.velocity; VALUE is JSON, and text where it is not. A list the document does
  /// not have is taken from `defaults` first. @throws SceneError
  void override_value(const std::string& assignment, const Json& defaults);

  const Json& root() const { return parsed_.json; }

  /// The whole document; valid as long as it is not changed.
  LocatedValue value() const;

  /// Something wrong with the value at a path, or with what is missing there: told where that
  /// value, or else the nearest around it, was written.
  Problem problem(std::string path, std::string message) const;

 private:
  friend class LocatedValue;
  Place place(TextPosition at) const;

  std::string source_;
  ParsedJson parsed_;  // a position without a line: in the override that its column counts to
  std::vector<std::string> overrides_;
};

/// A value of a document, and the way to it. It refers to the value that it is a part of, which
/// must outlive it.
class LocatedValue {
 public:
  const Json& json() const { return *json_; }
  bool is_root() const { return parent_ == nullptr; }

  /// A list's entry.
  LocatedValue operator[](std::size_t index) const;

  /// An object's value; none where it has no such key.
  std::optional<LocatedValue> find(std::string_view key) const;

  /// Calls f(key, value) for all of an object, in the order of the text.
  template <class F>
  void for_each_member(F f) const {
    const auto& members = json_->get_ref<const Json::object_t&>();
    for (std::size_t k = 0; k < members.size(); ++k)
      f(members.begin()[k].first, member(k));
  }

  /// Such as fluid.volumes[0].velocity; empty for the root.
  std::string path() const;

  Problem problem(std::string message) const;

 private:
  friend class SceneDocument;
  LocatedValue(const SceneDocument& document, const Json& json, TextPosition at,
               const JsonPositions* positions, const LocatedValue* parent = nullptr,
               std::string_view key = {}, std::size_t index = 0)
      : document_(&document),
        json_(&json),
        at_(at),
        positions_(positions),
        parent_(parent),
        key_(key),
        index_(index) {}

  LocatedValue member(std::size_t k) const;
  LocatedValue part(const Json& json, std::size_t k, std::string_view key) const;

  const SceneDocument* document_;
  const Json* json_;
  TextPosition at_;
  const JsonPositions* positions_;  // none: as the nearest value around it
  const LocatedValue* parent_;
  std::string_view key_;  // in the parent, where that is an object
  std::size_t index_;     // and where it is a list
};

/// "fluid" and "volumes" make "fluid.volumes"; "" and "fluid" make "fluid".
std::string child_path(std::string_view parent, std::string_view key);
std::string child_path(std::string_view parent, std::size_t index);

/// VALUE of KEY=VALUE, as typed: JSON, and text where it is not. @param place for messages
/// @throws SceneError for JSON that is beyond what parse_json accepts
Json typed_value(const std::string& typed, const Place& place);

/// Without spaces at its ends.
std::string trimmed(const std::string& text);

}  // namespace spindrift::app
