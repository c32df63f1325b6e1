// HTML pages made of templates, every value escaped for the place where it stands.
//
// A template is HTML with places: {{name}} stands for a value, {{#name}} ... {{/name}} for a piece
// that stands once for each record of a list (or once or never, by a truth value). What a place may
// hold follows from where it stands in the HTML, so that nobody can forget to escape:
//
//   in text, and in harmless attributes      a text
//   alone in the src of a picture and such   a Url
//   alone in a script of JSON                PageData
//   anywhere else (code, styles, tags)       nothing: the template is refused
//
// All places are filled in one pass: what looks like a place within a value is text like any other.
#pragma once

#include <concepts>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace spindrift::app {

/// What a picture or a link of a page refers to.
class Url {
 public:
  /// A file, by its path from the page's folder. Each byte that could mean more than itself is
  /// percent-encoded: no path is taken for an address with a scheme or a host.
  static Url of_file(const std::filesystem::path& file);
  /// A file's content within the page ("data:"), such as a picture of media type "image/png".
  static Url of_content(std::string_view media_type, std::string_view content);

  const std::string& text() const { return text_; }

 private:
  explicit Url(std::string text) : text_(std::move(text)) {}
  std::string text_;
};

/// JSON that a page's script reads; within strings nothing is left that could end the script.
struct PageData {
  explicit PageData(const nlohmann::ordered_json& json);
  std::string text;
};

struct PageValue;
/// Values by the names of their places.
using PageValues = std::map<std::string, PageValue, std::less<>>;

struct PageValue {
  PageValue(std::string text) : value(std::move(text)) {}
  PageValue(const char* text) : value(std::string(text)) {}
  PageValue(Url url) : value(std::move(url)) {}
  PageValue(PageData data) : value(std::move(data)) {}
  PageValue(std::vector<PageValues> records) : value(std::move(records)) {}
  PageValue(std::same_as<bool> auto shown) : value(shown) {}

  std::variant<std::string, Url, PageData, std::vector<PageValues>, bool> value;
};

class PageTemplate {
 public:
  /// @throws std::logic_error saying what is wrong with the template
  explicit PageTemplate(std::string_view text);

  /// The page. A place within a list's piece takes the record's value, or else that from around it.
  /// @throws std::logic_error naming a place that has no value, or one of another kind, and a value
  /// that has no place
  std::string fill(const PageValues& values) const;

 private:
  enum class Kind { markup, text, url, data, piece };
  struct Part {
    Kind kind = Kind::markup;
    std::string text = {};                          ///< of markup; else the place's name
    std::vector<Part> parts = {};                   ///< of a piece
    std::set<std::string, std::less<>> names = {};  ///< of all places in a piece
  };
  struct Scope {
    const PageValues& values;
    const Scope* around;
  };
  class Reader;

  static const PageValue& value_of(const std::string& name, const Scope* scope);
  static void fill_piece(const Part& piece, const PageValues& values, const Scope* around,
                         std::string& page);
  static void fill_place(const Part& place, const Scope& scope, std::string& page);

  Part whole_;
};

}  // namespace spindrift::app
