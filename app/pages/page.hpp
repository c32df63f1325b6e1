// Makes HTML pages, such as the reports of the commands, from templates in which every value is
// escaped for the place where it stands.
//
// A template is HTML with places: {{name}} stands for a value, and {{#name}} ... {{/name}} for a
// piece that is repeated for each record of a list, or shown or left out by a truth value. The kind
// of value that a place may hold follows from where it stands in the HTML, so that nobody can
// forget to escape:
//
//   in text, and in harmless attributes      a text
//   alone in the src of a picture and such   a Url
//   alone in a script of JSON                PageData
//   anywhere else (code, styles, tags)       nothing: the template is refused
//
// All places are filled in one pass, so that anything within a value that looks like a place is
// plain text.
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

/// The address of a picture or the target of a link.
class Url {
 public:
  /// The address of a file, by its path from the page's folder. Each byte that could mean more than
  /// itself is percent-encoded, so that no path is taken for an address with a scheme or a host.
  static Url of_file(const std::filesystem::path& file);
  /// An address that holds a file's content itself ("data:"), such as a picture of media type
  /// "image/png".
  static Url of_content(std::string_view media_type, std::string_view content);

  const std::string& text() const { return text_; }

 private:
  explicit Url(std::string text) : text_(std::move(text)) {}
  std::string text_;
};

/// JSON for a script of the page. Characters in its strings that could end the script element are
/// escaped.
struct PageData {
  explicit PageData(const nlohmann::ordered_json& json);
  std::string text;
};

struct PageValue;
/// The values of a page or a record, by the names of their places.
using PageValues = std::map<std::string, PageValue, std::less<>>;

/// The value of a place: a text, a Url, data, the records of a list, or whether a piece is shown.
struct PageValue {
  // Tables of values are written as {{"name", value}, …}.
  // NOLINTBEGIN(google-explicit-constructor)
  PageValue(std::string text) : value(std::move(text)) {}
  PageValue(const char* text) : value(std::string(text)) {}
  PageValue(Url url) : value(std::move(url)) {}
  PageValue(PageData data) : value(std::move(data)) {}
  PageValue(std::vector<PageValues> records) : value(std::move(records)) {}
  PageValue(std::same_as<bool> auto shown) : value(shown) {}
  // NOLINTEND(google-explicit-constructor)

  std::variant<std::string, Url, PageData, std::vector<PageValues>, bool> value;
};

/// A parsed template.
class PageTemplate {
 public:
  /// @throws std::logic_error that says what is wrong with the template
  explicit PageTemplate(std::string_view text);

  /// Makes the page. A place within a list's piece takes the value of the record, or else that of
  /// the enclosing records or of the page.
  /// @throws std::logic_error that names a place without a value or with one of another kind, or a
  /// value without a place
  std::string fill(const PageValues& values) const;

 private:
  enum class Kind { markup, text, url, data, piece };
  struct Part {
    Kind kind = Kind::markup;
    std::string text = {};                          ///< the markup itself, or the place's name
    std::vector<Part> parts = {};                   ///< the parts of a piece
    std::set<std::string, std::less<>> names = {};  ///< the names of all places in a piece
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
