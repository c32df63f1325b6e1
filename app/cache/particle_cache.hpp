// The cache of simulated particles on disk, one file per frame, so that a simulation is not done
// twice and can be continued.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cache/simulation_record.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// A frame and the statistics of the time steps that led to it.
struct CachedFrame {
  sim::Frame frame;
  sim::FrameStatistics statistics;
};

/// A folder with the frames of one simulation, numbered from 0. Each file holds the simulation's
/// hash, its frame's number and a checksum, so that damaged and foreign files are recognised.
class ParticleCache {
 public:
  /// @param simulation hash of the simulation that the files must belong to
  ParticleCache(std::filesystem::path folder, std::string simulation)
      : folder_(std::move(folder)), simulation_(std::move(simulation)) {}

  /// Opens the folder of any run and takes the simulation's hash from its first frame.
  /// @throws std::runtime_error that names the first frame's file when it can't be read
  explicit ParticleCache(std::filesystem::path folder);

  /// The hash of the simulation.
  const std::string& simulation() const { return simulation_; }

  /// Reads a frame.
  /// @throws std::runtime_error that names the file when it is missing, damaged, of another format,
  /// or not this frame of this simulation
  CachedFrame read(int number) const;
  /// Reads a frame; nothing where it is missing or can't be used.
  std::optional<CachedFrame> find(int number) const;
  /// Writes a frame, in place of whatever has its file's name.
  /// @throws std::runtime_error that names the file when it can't be written
  void write(int number, const CachedFrame& cached) const;

  /// Writes the values that probes read between the frame before and this frame into a file beside
  /// the frame's.
  /// @param name tells different sets of probes apart
  /// @throws std::runtime_error that names the file when it can't be written
  void write_readings(int number, const std::string& name, const std::vector<double>& values) const;
  /// Reads these values; nothing where they are missing or can't be used.
  std::optional<std::vector<double>> read_readings(int number, const std::string& name) const;

  /// Writes the record of how the frames were simulated into a file beside them.
  void write_record(const SimulationRecord& record) const;
  /// Reads that record; nothing where it is missing or can't be used.
  std::optional<SimulationRecord> read_record() const;

  /// The path of a frame's file.
  std::filesystem::path file(int number) const;

 private:
  std::filesystem::path folder_;
  std::string simulation_;
};

}  // namespace spindrift::app
