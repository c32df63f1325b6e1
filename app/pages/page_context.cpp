#include "app/pages/page_context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace spindrift::app {
namespace {

constexpr std::string_view spaces = " \t\n";

}  // namespace

void refuse_template(const std::string& what) {
  throw std::logic_error("page template: " + what);
}

bool PageContext::in_harmless_attribute() const {
  static constexpr std::array<std::string_view, 4> harmless{"alt", "class", "id", "title"};
  return at_ == At::value &&
         (std::find(harmless.begin(), harmless.end(), attribute_) != harmless.end() ||
          attribute_.starts_with("data-") || attribute_.starts_with("aria-"));
}

bool PageContext::at_url() const {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 4> urls{
      Pair{"a", "href"}, {"img", "src"}, {"video", "poster"}, {"video", "src"}};
  return at_ == At::value && value_.empty() &&
         std::find(urls.begin(), urls.end(), Pair{element_, attribute_}) != urls.end();
}

void PageContext::read(std::string_view markup) {
  while (!markup.empty()) {
    switch (at_) {
      case At::text:
        markup = read_text(markup);
        break;
      case At::tag:
        markup = read_tag(markup);
        break;
      case At::value:
        markup = read_value(markup);
        break;
      case At::data:
      case At::code:
        markup = read_script(markup);
        break;
    }
  }
}

std::string_view PageContext::read_text(std::string_view markup) {
  markup.remove_prefix(std::min(markup.find('<'), markup.size()));
  if (markup.empty())
    return markup;
  if (markup.starts_with("<!--")) {
    const std::size_t end = markup.find("-->");
    if (end == std::string_view::npos)
      refuse_template("a place in a comment");
    return markup.substr(end + 3);
  }
  markup.remove_prefix(1);
  const std::size_t end = std::min(markup.find_first_of(" \t\n>"), markup.size());
  element_ = markup.substr(0, end);
  holds_json_ = false;
  at_ = At::tag;
  return markup.substr(end);
}

std::string_view PageContext::read_tag(std::string_view markup) {
  const std::size_t end = markup.find_first_of("\"'>");
  if (end == std::string_view::npos)
    return {};
  if (markup[end] == '>') {
    const bool raw = element_ == "script" || element_ == "style";
    at_ = !raw ? At::text : holds_json_ ? At::data : At::code;
    value_.clear();
    return markup.substr(end + 1);
  }
  std::string_view name = markup.substr(0, end);
  if (markup[end] == '\'' || !name.ends_with('='))
    refuse_template(fmt::format("an attribute of <{}> without double quotes", element_));
  name.remove_suffix(1);
  name.remove_prefix(std::min(name.find_last_of(spaces) + 1, name.size()));
  attribute_ = name;
  value_.clear();
  at_ = At::value;
  return markup.substr(end + 1);
}

std::string_view PageContext::read_value(std::string_view markup) {
  const std::size_t end = std::min(markup.find('"'), markup.size());
  value_ += markup.substr(0, end);
  if (end == markup.size())
    return {};
  if (attribute_ == "type")
    holds_json_ = value_ == "application/json";
  at_ = At::tag;
  return markup.substr(end + 1);
}

std::string_view PageContext::read_script(std::string_view markup) {
  const std::size_t end = std::min(markup.find("</" + element_), markup.size());
  value_ += markup.substr(0, end);
  if (end < markup.size())
    at_ = At::text;
  return markup.substr(end);
}

}  // namespace spindrift::app
