// Particles kept on disk, a file per frame, so that a simulation is not done twice and can be gone
// on with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/kept/simulation_record.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// A frame and what happened on the way to it.
struct KeptFrame {
  sim::Frame frame;
  sim::FrameStatistics statistics;
};

/// A folder of one simulation's frames, numbered from 0. Each file names its simulation and its
/// number and bears a checksum, so that a damaged or foreign one is told from a good one.
class ParticleCache {
 public:
  /// @param simulation the hash of the simulation that the files must be of
  ParticleCache(std::filesystem::path folder, std::string simulation)
      : folder_(std::move(folder)), simulation_(std::move(simulation)) {}

  /// The folder of somebody else's run: its simulation is that of its first frame.
  /// @throws std::runtime_error that names the file when that can't be read
  explicit ParticleCache(std::filesystem::path folder);

  /// The hash of the simulation.
  const std::string& simulation() const { return simulation_; }

  /// @throws std::runtime_error that names the file when it is missing, damaged, of another format,
  /// or not this frame of this simulation.
  KeptFrame read(int number) const;
  /// The same, or nothing where there is no good file.
  std::optional<KeptFrame> find(int number) const;
  /// Writes a frame, in place of whatever has its name.
  /// @throws std::runtime_error that names the file when it can't be written.
  void write(int number, const KeptFrame& kept) const;

  /// What probes read on the way to a frame, beside it. @param name tells the probes apart
  void write_readings(int number, const std::string& name, const std::vector<double>& values) const;
  /// Nothing where none are kept, or none that can be used.
  std::optional<std::vector<double>> read_readings(int number, const std::string& name) const;

  /// How the frames were simulated, beside them.
  void write_record(const SimulationRecord& record) const;
  /// Nothing where it is not known.
  std::optional<SimulationRecord> read_record() const;

  std::filesystem::path file(int number) const;

 private:
  std::filesystem::path folder_;
  std::string simulation_;
};

}  // namespace spindrift::app
