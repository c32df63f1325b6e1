// Where in an HTML document a place stands.
#pragma once

#include <string>
#include <string_view>

namespace spindrift::app {

/// @throws std::logic_error saying what is wrong with a template or with what it is filled with
[[noreturn]] void refuse_template(const std::string& what);

/// Follows the markup of a page's template. It knows as much of HTML as the templates use: tags
/// with attributes in double quotes, comments, scripts and styles.
class PageContext {
 public:
  /// @throws std::logic_error for markup that it does not know
  void read(std::string_view markup);

  bool in_text() const { return at_ == At::text; }
  /// In an attribute's value that a browser only shows or compares.
  bool in_harmless_attribute() const;
  /// At the beginning of an attribute's value that a browser fetches as a picture or a video, or
  /// follows when it is clicked.
  bool at_url() const;
  /// At the beginning of a script that is not run, since it holds JSON.
  bool at_data() const { return at_ == At::data && value_.empty(); }

 private:
  enum class At { text, tag, value, data, code };

  std::string_view read_text(std::string_view markup);
  std::string_view read_tag(std::string_view markup);
  std::string_view read_value(std::string_view markup);
  std::string_view read_script(std::string_view markup);

  At at_ = At::text;
  std::string element_;    ///< whose tag or content it is
  std::string attribute_;  ///< whose value it is
  std::string value_;      ///< of the attribute or of the script, up to here
  bool holds_json_ = false;
};

}  // namespace spindrift::app
