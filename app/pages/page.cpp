#include "app/pages/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/pages/page_context.hpp"

namespace spindrift::app {
namespace {

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

/// Escapes text so that HTML shows it as it is, in text and in quoted attributes.
std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// Whether a character needs no encoding in a path: the "unreserved" ones of RFC 3986, which stand
/// for nothing but themselves, and the slash between folders.
bool plain_in_path(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

Url Url::of_file(const std::filesystem::path& file) {
  std::string_view path = file.native();
  while (path.starts_with("//"))  // a name after two slashes would be taken for a host
    path.remove_prefix(1);
  std::string text;
  for (const char c : path)
    if (plain_in_path(c))
      text += c;
    else
      text += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return Url(std::move(text));
}

Url Url::of_content(std::string_view media_type, std::string_view content) {
  return Url(fmt::format("data:{};base64,{}", media_type, base64(content)));
}

PageData::PageData(const nlohmann::ordered_json& json) {
  const std::string plain = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  text.reserve(plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::string_view rest = std::string_view(plain).substr(i);
    if (plain[i] == '<' || plain[i] == '>' || plain[i] == '&') {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(plain[i]));
    } else if (rest.starts_with("\u2028") || rest.starts_with("\u2029")) {
      text += rest.starts_with("\u2028") ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      text += plain[i];
    }
  }
}

/// Parses a template into its parts.
class PageTemplate::Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  Part read_whole() {
    Part whole = read_piece("");
    if (!context_.in_text())
      refuse_template("it ends within a tag or a script");
    return whole;
  }

 private:
  Part read_piece(const std::string& name) {
    Part piece{.kind = Kind::piece, .text = name};
    for (;;) {
      const std::size_t begin = std::min(rest_.find("{{"), rest_.size());
      context_.read(rest_.substr(0, begin));
      piece.parts.push_back({.text = std::string(rest_.substr(0, begin))});
      rest_.remove_prefix(begin);
      if (rest_.empty()) {
        if (!name.empty())
          refuse_template(fmt::format("{{{{#{}}}}} has no end", name));
        return piece;
      }
      const std::string place = read_place();
      if (place == "/" + name)
        return piece;
      piece.parts.push_back(part_of(place));
      const Part& part = piece.parts.back();
      piece.names.insert(part.text);
      piece.names.insert(part.names.begin(), part.names.end());
    }
  }

  /// Reads a place, {{...}}, and returns the text between the braces.
  std::string read_place() {
    const std::size_t end = rest_.find("}}");
    if (end == std::string_view::npos)
      refuse_template("{{ without }}");
    std::string place(rest_.substr(2, end - 2));
    rest_.remove_prefix(end + 2);
    const auto plain = [](char c) { return ('a' <= c && c <= 'z') || c == '_'; };
    const std::size_t sign = place.starts_with('#') || place.starts_with('/') ? 1 : 0;
    if (place.size() == sign || !std::all_of(place.begin() + long(sign), place.end(), plain))
      refuse_template(fmt::format("{{{{{}}}}} is no place", place));
    if (sign == 1 && !context_.in_text())
      refuse_template(fmt::format("{{{{{}}}}} does not stand in text", place));
    return place;
  }

  Part part_of(const std::string& place) {
    if (place.front() == '#')
      return read_piece(place.substr(1));
    if (place.front() == '/')
      refuse_template(fmt::format("{{{{{}}}}} ends nothing", place));
    if (context_.in_text() || context_.in_harmless_attribute())
      return {.kind = Kind::text, .text = place};
    if (context_.at_url() && rest_.starts_with('"'))
      return {.kind = Kind::url, .text = place};
    if (context_.at_data() && rest_.starts_with("</script>"))
      return {.kind = Kind::data, .text = place};
    refuse_template(fmt::format("{{{{{}}}}} stands where no value is safe", place));
  }

  std::string_view rest_;
  PageContext context_;
};

PageTemplate::PageTemplate(std::string_view text) : whole_(Reader(text).read_whole()) {}

std::string PageTemplate::fill(const PageValues& values) const {
  std::string page;
  fill_piece(whole_, values, nullptr, page);
  return page;
}

const PageValue& PageTemplate::value_of(const std::string& name, const Scope* scope) {
  for (; scope != nullptr; scope = scope->around)
    if (const auto found = scope->values.find(name); found != scope->values.end())
      return found->second;
  refuse_template(fmt::format("{{{{{}}}}} has no value", name));
}

void PageTemplate::fill_piece(const Part& piece, const PageValues& values, const Scope* around,
                              std::string& page) {
  for (const auto& [name, value] : values)
    if (!piece.names.contains(name))
      refuse_template(fmt::format("the value {} has no place", name));
  const Scope scope{values, around};
  for (const Part& part : piece.parts)
    if (part.kind == Kind::markup)
      page += part.text;
    else
      fill_place(part, scope, page);
}

void PageTemplate::fill_place(const Part& place, const Scope& scope, std::string& page) {
  const auto& value = value_of(place.text, &scope).value;
  if (place.kind == Kind::text && std::holds_alternative<std::string>(value)) {
    page += html_escaped(std::get<std::string>(value));
  } else if (place.kind == Kind::url && std::holds_alternative<Url>(value)) {
    page += std::get<Url>(value).text();  // a Url is encoded when it is made
  } else if (place.kind == Kind::data && std::holds_alternative<PageData>(value)) {
    page += std::get<PageData>(value).text;
  } else if (place.kind == Kind::piece && std::holds_alternative<bool>(value)) {
    if (std::get<bool>(value))
      fill_piece(place, {}, &scope, page);
  } else if (place.kind == Kind::piece && std::holds_alternative<std::vector<PageValues>>(value)) {
    for (const PageValues& record : std::get<std::vector<PageValues>>(value))
      fill_piece(place, record, &scope, page);
  } else {
    refuse_template(
        fmt::format("the value of {{{{{}}}}} is of another kind than its place", place.text));
  }
}

}  // namespace spindrift::app
