// A scene file as JSON, with the overrides of the command line applied, that knows where each value
// was written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/errors/scene_error.hpp"
#include "app/files/json_parser.hpp"

namespace spindrift::app {

class LocatedValue;

/// A parsed scene file and the overrides that were applied to it.
class SceneDocument {
 public:
  /// @param text JSON with comments, as parse_json accepts it
  /// @param source the file's name in messages
  /// @throws SceneError with line and column for every text that parse_json refuses
  SceneDocument(std::string_view text, std::string source);

  /// Applies `KEY=VALUE` to the document. KEY is a path such as fluid.volumes[0].velocity or
  /// fluid.volumes.0.velocity; VALUE is JSON, and is taken as text where it is not JSON. A list
  /// that the document does not have is first copied from `defaults`.
  /// @throws SceneError
  void override_value(const std::string& assignment, const Json& defaults);

  const Json& root() const { return parsed_.json; }

  /// The whole document as a value; it is valid until the document is changed.
  LocatedValue value() const;

  /// A problem with the value at a path, or with a value missing there. Its place is that of the
  /// value, or else of the nearest value that encloses the path.
  Problem problem(std::string path, std::string message) const;

 private:
  friend class LocatedValue;
  Place place(TextPosition at) const;

  std::string source_;
  ParsedJson parsed_;  // a position with line 0 stands for the override whose index is the column
  std::vector<std::string> overrides_;
};

/// A value of a document, with its key path and the place where it was written. It refers to the
/// value that it is a part of, which must outlive it.
class LocatedValue {
 public:
  const Json& json() const { return *json_; }
  bool is_root() const { return parent_ == nullptr; }

  /// The entry of a list.
  LocatedValue operator[](std::size_t index) const;

  /// The value of a key of an object; none where the object has no such key.
  std::optional<LocatedValue> find(std::string_view key) const;

  /// Calls f(key, value) for all members of an object, in the order of the text.
  template <class F>
  void for_each_member(F f) const {
    const auto& members = json_->get_ref<const Json::object_t&>();
    for (std::size_t k = 0; k < members.size(); ++k)
      f(members.begin()[k].first, member(k));
  }

  /// The key path, such as fluid.volumes[0].velocity; empty for the root.
  std::string path() const;

  /// Its place and its key path, as in "scene.json:3:14: fluid.viscosity".
  std::string place_and_path() const;

  /// A problem with this value, at its place.
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
  const JsonPositions* positions_;  // null where only the enclosing value's position is known
  const LocatedValue* parent_;
  std::string_view key_;  // in the parent, where the parent is an object
  std::size_t index_;     // in the parent, where the parent is a list
};

/// The key path of an object's member: "fluid" and "volumes" make "fluid.volumes"; "" and "fluid"
/// make "fluid".
std::string child_path(std::string_view parent, std::string_view key);
/// The key path of a list's entry: "fluid.volumes" and 0 make "fluid.volumes[0]".
std::string child_path(std::string_view parent, std::size_t index);

/// The VALUE of a typed KEY=VALUE: the JSON that it is, or else its text.
/// @param place the place that an error names
/// @throws SceneError for JSON that is beyond what parse_json accepts
Json typed_value(const std::string& typed, const Place& place);

/// The text without the spaces at its ends.
std::string trimmed(const std::string& text);

}  // namespace spindrift::app
