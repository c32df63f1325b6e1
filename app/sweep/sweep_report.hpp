// The HTML report of a sweep.
#pragma once

#include <string>

#include "app/tables/document.hpp"

namespace spindrift::app {

/// The whole page in one text. It shows the videos and pictures that lie beside it.
/// @param results the results of results_json(), with the curves of the probes in each run
std::string sweep_html(const Json& results);

}  // namespace spindrift::app
