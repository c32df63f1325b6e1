// What tests look for in an HTML page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::test {

/// The data of all plots of a page, in their order.
inline std::vector<nlohmann::json> plots_in(const std::string& page) {
  constexpr std::string_view begin = "<figure class=\"plot\"><script type=\"application/json\">";
  std::vector<nlohmann::json> plots;
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    plots.push_back(nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at)));
  }
  return plots;
}

}  // namespace spindrift::test
