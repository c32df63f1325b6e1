#include "app/files/json_file.hpp"

#include <stdexcept>

#include "render/output/input_file.hpp"

namespace spindrift::app {

namespace {

/// The deepest nesting that is read, more than anything the program writes. The limit exists
/// because working with JSON takes stack for each level.
constexpr int most_levels = 64;

}  // namespace

nlohmann::ordered_json json_in(const std::filesystem::path& file) {
  try {
    const auto shallow = [](int level, auto, auto&) {
      if (level > most_levels)
        throw std::runtime_error("nested too deeply");
      return true;
    };
    auto json = nlohmann::ordered_json::parse(output::read_file(file), shallow, false);
    return json.is_discarded() ? nlohmann::ordered_json() : json;
  } catch (const std::runtime_error&) {
    return {};
  }
}

std::string text_in(const nlohmann::ordered_json& json, const std::string& name) {
  const bool there = json.is_object() && json.contains(name) && json[name].is_string();
  return there ? json[name].get<std::string>() : "";
}

}  // namespace spindrift::app
