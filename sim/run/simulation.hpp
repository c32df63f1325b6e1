// The liquid, advanced in time.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "sim/core/frame.hpp"
#include "sim/core/phase_clock.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"
#include "sim/run/backend_choice.hpp"

namespace spindrift::sim {

class Engine;

/// The size of a run, and where its time went.
struct RunFigures {
  std::size_t particles = 0;
  std::size_t boundary_particles = 0;
  std::size_t memory_bytes = 0;   ///< of all that the run holds, on a GPU of what is there
  std::vector<PhaseTime> phases;  ///< wall time so far
};

/// The liquid of a scene, advanced in time on the backend that its settings ask for.
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
  RunFigures figures() const;

 private:
  BackendChoice backend_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace spindrift::sim
