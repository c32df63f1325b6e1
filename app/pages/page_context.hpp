// Follows the HTML of a page's template to tell which values are safe in its places.
#pragma once

#include <string>
#include <string_view>

namespace spindrift::app {

/// Refuses a template, or the values that it is filled with.
/// @throws std::logic_error that says what is wrong
[[noreturn]] void refuse_template(const std::string& what);

/// The position in a template, after the markup that has been read. It understands as much of HTML
/// as the templates use: tags with attributes in double quotes, comments, scripts and styles.
class PageContext {
 public:
  /// Reads the markup up to the next place.
  /// @throws std::logic_error for markup that is not understood
  void read(std::string_view markup);

  bool in_text() const { return at_ == At::text; }
  /// Whether this is within an attribute's value that a browser only shows or compares.
  bool in_harmless_attribute() const;
  /// Whether this is the beginning of an attribute's value that a browser fetches as a picture or a
  /// video, or follows when it is clicked.
  bool at_url() const;
  /// Whether this is the beginning of a script that is not run, since it holds JSON.
  bool at_data() const { return at_ == At::data && value_.empty(); }

 private:
  enum class At { text, tag, value, data, code };

  std::string_view read_text(std::string_view markup);
  std::string_view read_tag(std::string_view markup);
  std::string_view read_value(std::string_view markup);
  std::string_view read_script(std::string_view markup);

  At at_ = At::text;
  std::string element_;      ///< name of the element whose tag or content is being read
  std::string attribute_;    ///< name of the attribute whose value is being read
  std::string value_;        ///< value of the attribute, or text of the script, up to here
  bool holds_json_ = false;  ///< whether the element has type="application/json"
};

}  // namespace spindrift::app
