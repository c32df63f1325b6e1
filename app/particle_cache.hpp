// Particles kept on disk, a file per frame, so that a simulation is not done twice and can be gone
// on with.
#pragma once

#include <filesystem>
#include <optional>

#include "sim/simulation.hpp"

namespace spindrift::app {

/// A frame and what happened on the way to it.
struct KeptFrame {
  sim::Frame frame;
  sim::FrameStatistics statistics;
};

/// A folder of frames, numbered from 0.
class ParticleCache {
 public:
  explicit ParticleCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool has(int number) const;
  /// @throws std::runtime_error that names the file when it is missing, cut short or of another
  /// format.
  KeptFrame read(int number) const;
  /// @throws std::runtime_error that names the file when it can't be written.
  void write(int number, const KeptFrame& kept) const;

  /// What probes read on the way to a frame, beside it. @param name tells the probes apart
  void write_readings(int number, const std::string& name, const std::vector<double>& values) const;
  /// Nothing where none are kept.
  std::optional<std::vector<double>> read_readings(int number, const std::string& name) const;

  std::filesystem::path file(int number) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace spindrift::app
