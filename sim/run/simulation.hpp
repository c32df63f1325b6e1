// The liquid, advanced in time.
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "sim/core/frame.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"
#include "sim/run/backend_choice.hpp"

namespace spindrift::sim {

struct PhaseTime {
  std::string name;
  double seconds = 0;
  std::int64_t calls = 0;
};

class Engine;

class Simulation {
 public:
  /// Fills the volumes and samples the walls. @throws std::invalid_argument when nothing can be
  /// simulated, Stopped when `stop` becomes true meanwhile
  explicit Simulation(const Settings& settings, Stop stop = nullptr);
  /// Goes on from a frame of an earlier run with the same settings.
  Simulation(const Settings& settings, const Frame& start, Stop stop = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances to `time` exactly. @throws std::runtime_error when no admissible time step exists.
  /// When `stop` becomes true it returns early, in the middle of a step; the state is then of no
  /// use.
  FrameStatistics advance_to(double time, Stop stop = nullptr);

  /// The particles as they are now, for whoever asks for them, in any thread and at any time: on a
  /// GPU they cross over while later steps run.
  std::future<Frame> take_frame();
  Frame frame() { return take_frame().get(); }
  const BackendChoice& backend() const { return backend_; }
  std::size_t particle_count() const;
  std::size_t boundary_particle_count() const;
  std::size_t memory_bytes() const;
  std::vector<PhaseTime> phase_times() const;

 private:
  BackendChoice backend_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace spindrift::sim
