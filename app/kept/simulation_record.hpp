// How particles came about, kept beside them, so that a run that only draws them can still say.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/simulation.hpp"

namespace spindrift::app {

struct SimulationRecord {
  std::string scene_name, scene_file;         ///< whose the particles are; the file may be unknown
  std::optional<sim::BackendChoice> backend;  ///< none: it is not known
  std::size_t boundary_particles = 0;
  std::size_t bytes = 0;               ///< of the simulation's own memory
  double seconds = 0;                  ///< wall time in all sittings together
  std::vector<sim::PhaseTime> phases;  ///< the same by phase

  /// Goes on from what an earlier run left; whose the particles are is not taken over.
  void take_over(const std::optional<SimulationRecord>& earlier);
  /// Adds what the phases of a sitting took.
  void add_phases(const std::vector<sim::PhaseTime>& sitting);
};

/// Its file's name, in the folder of the kept particles.
inline constexpr const char* simulation_record_file = "simulation.json";

nlohmann::ordered_json json_of(const SimulationRecord& record);

/// @throws nlohmann::json::exception for JSON that is not such a record
SimulationRecord simulation_record_of(const nlohmann::ordered_json& json);

/// The backend's name, and why it is that.
nlohmann::ordered_json json_of(const sim::BackendChoice& choice);

/// The phases, by their names.
nlohmann::ordered_json json_of(const std::vector<sim::PhaseTime>& phases);

}  // namespace spindrift::app
