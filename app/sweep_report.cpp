#include "app/sweep_report.hpp"

#include "app/plot.hpp"
#include "app/sweep_page.hpp"

namespace spindrift::app {
namespace {

void replace(std::string& page, std::string_view mark, const std::string& by) {
  for (auto at = page.find(mark); at != std::string::npos; at = page.find(mark, at + by.size()))
    page.replace(at, mark.size(), by);
}

}  // namespace

std::string sweep_html(const Json& results) {
  std::string data = results.dump(-1, ' ', false, Json::error_handler_t::replace);
  replace(data, "</", "<\\/");  // it must not end the element that holds it
  replace(data, "<!--", "<\\u0021--");
  std::string page(sweep_page);
  replace(page, "{{title}}", html_escaped("Sweep of " + results.at("scene").get<std::string>()));
  replace(page, "{{data}}", data);
  return page;
}

}  // namespace spindrift::app
