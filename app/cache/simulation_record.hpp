// The record of how cached particles were simulated. It is a file beside them, so that a run that
// only draws them can still report it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// How the frames of a simulation came about, in one run or in several that continued each other.
struct SimulationRecord {
  std::string scene_name, scene_file;         ///< the scene's; the file is empty where unknown
  std::optional<sim::BackendChoice> backend;  ///< none where it is not known
  std::size_t boundary_particles = 0;
  std::size_t bytes = 0;               ///< memory that the simulation itself took
  double seconds = 0;                  ///< wall-clock time of all runs together
  std::vector<sim::PhaseTime> phases;  ///< wall-clock time of all runs together, by phase

  /// Takes over all but the scene's name and file from the record of an earlier run.
  void take_over(const std::optional<SimulationRecord>& earlier);
  /// Adds the times of the phases of one run.
  void add_phases(const std::vector<sim::PhaseTime>& sitting);
};

/// The name of the record's file in the folder of the cached particles.
inline constexpr const char* simulation_record_file = "simulation.json";

nlohmann::ordered_json json_of(const SimulationRecord& record);

/// Reads a record from the JSON that json_of makes of it.
/// @throws nlohmann::json::exception for JSON that is not such a record
SimulationRecord simulation_record_of(const nlohmann::ordered_json& json);

/// The backend's name, and the reason why it was chosen.
nlohmann::ordered_json json_of(const sim::BackendChoice& choice);

/// An object with the seconds and calls of each phase under the phase's name.
nlohmann::ordered_json json_of(const std::vector<sim::PhaseTime>& phases);

}  // namespace spindrift::app
