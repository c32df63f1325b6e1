#include "app/cache/simulation_record.hpp"

#include <algorithm>

#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {

void SimulationRecord::take_over(const std::optional<SimulationRecord>& earlier) {
  if (!earlier)
    return;
  const std::string name = scene_name, file = scene_file;
  *this = *earlier;
  scene_name = name;
  scene_file = file;
}

void SimulationRecord::add_phases(const std::vector<sim::PhaseTime>& sitting) {
  for (const sim::PhaseTime& phase : sitting) {
    const auto same = std::find_if(phases.begin(), phases.end(),
                                   [&](const auto& p) { return p.name == phase.name; });
    if (same == phases.end()) {
      phases.push_back(phase);
      continue;
    }
    same->seconds += phase.seconds;
    same->calls += phase.calls;
  }
}

nlohmann::ordered_json json_of(const std::vector<sim::PhaseTime>& phases) {
  auto json = nlohmann::ordered_json::object();
  for (const sim::PhaseTime& phase : phases)
    json[phase.name] = {{"seconds", phase.seconds}, {"calls", phase.calls}};
  return json;
}

nlohmann::ordered_json json_of(const sim::BackendChoice& choice) {
  return {{"name", json_of(choice.backend)}, {"reason", choice.reason}};
}

nlohmann::ordered_json json_of(const SimulationRecord& record) {
  nlohmann::ordered_json json{{"scene_name", record.scene_name},
                              {"scene_file", record.scene_file},
                              {"boundary_particles", record.boundary_particles},
                              {"bytes", record.bytes},
                              {"seconds", record.seconds},
                              {"phases", json_of(record.phases)}};
  if (record.backend)
    json["backend"] = json_of(*record.backend);
  return json;
}

SimulationRecord simulation_record_of(const nlohmann::ordered_json& json) {
  SimulationRecord record{.scene_name = json.at("scene_name"),
                          .scene_file = json.at("scene_file"),
                          .backend = {},
                          .boundary_particles = json.at("boundary_particles"),
                          .bytes = json.at("bytes"),
                          .seconds = json.at("seconds"),
                          .phases = {}};
  for (const auto& [name, phase] : json.at("phases").items())
    record.phases.push_back({name, phase.at("seconds"), phase.at("calls")});
  if (json.contains("backend"))
    record.backend = {
        .backend = json.at("backend").at("name") == "cuda" ? sim::Backend::cuda : sim::Backend::cpu,
        .reason = json.at("backend").at("reason")};
  return record;
}

}  // namespace spindrift::app
