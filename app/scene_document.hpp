// A scene file as JSON, with overrides laid over it, that knows where each value was written.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::app {

using Json = nlohmann::ordered_json;

class SceneDocument {
 public:
  /// @param source the file's name in messages
  /// @throws SceneError with file, line and column when `text` is not JSON (comments are allowed).
  SceneDocument(std::string_view text, std::string source);

  /// Lays `KEY=VALUE` over the document. KEY is a path such as fluid.volumes[0].velocity or
  /// fluid.volumes.0.velocity; VALUE is JSON, and text where it is not. A list the document does
  /// not have is taken from `defaults` first. @throws SceneError
  void override_value(const std::string& assignment, const Json& defaults);

  const Json& root() const { return root_; }

  /// Where the value at a path, or the nearest value around it, was written: "file:line:column" or
  /// "--set KEY=VALUE".
  std::string place_of(std::string path) const;

 private:
  std::string source_;
  Json root_;
  std::map<std::string, std::string, std::less<>> places_;  // by path; the root's is ""
  std::vector<std::string> overridden_;                     // paths
};

/// "fluid" and "volumes" make "fluid.volumes"; "" and "fluid" make "fluid".
std::string child_path(std::string_view parent, std::string_view key);
std::string child_path(std::string_view parent, std::size_t index);

/// Without spaces at its ends.
std::string trimmed(const std::string& text);

}  // namespace spindrift::app
