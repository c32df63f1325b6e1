// The page that shows a sweep.
#pragma once

#include <string>

#include "app/tables/document.hpp"

namespace spindrift::app {

/// The whole page, in one text; it shows the videos and pictures that lie beside it.
/// @param results those of results_json(), with what else the page shows
std::string sweep_html(const Json& results);

}  // namespace spindrift::app
