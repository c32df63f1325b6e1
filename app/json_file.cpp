#include "app/json_file.hpp"

#include <stdexcept>

#include "render/output/input_file.hpp"

namespace spindrift::app {

nlohmann::ordered_json json_in(const std::filesystem::path& file) {
  try {
    auto json = nlohmann::ordered_json::parse(output::read_file(file), nullptr, false);
    return json.is_discarded() ? nlohmann::ordered_json() : json;
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace spindrift::app
