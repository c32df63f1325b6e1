#include "app/sweep/sweep_report.hpp"

#include "app/pages/page.hpp"
#include "app/pages/sweep_page.hpp"

namespace spindrift::app {

std::string sweep_html(const Json& results) {
  return PageTemplate(sweep_page)
      .fill({{"title", "Sweep of " + results.at("scene").get<std::string>()},
             {"data", PageData(results)}});
}

}  // namespace spindrift::app
