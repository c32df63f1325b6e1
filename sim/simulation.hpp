// The liquid, advanced in time.
#pragma once

#include <cstdint>
#include <future>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "sim/backend_choice.hpp"
#include "sim/exchange.hpp"
#include "sim/settings.hpp"
#include "sim/stop.hpp"

namespace spindrift::sim {

/// Particle data at one instant, in the solver's order: with the time steps all that is needed to
/// go on from here to the same bytes.
struct Frame {
  double time = 0;                   ///< s
  std::vector<glm::vec3> positions;  ///< m
  std::vector<glm::vec3>
      velocities;  ///< over the step that ended here (leapfrog: at its middle), m/s
  std::vector<float>
      densities;  ///< kg/m³, recomputed from the positions with the full neighbourhood
  std::vector<float> pressures;    ///< in the sense of mechanics, mean since the last frame, Pa
  std::vector<float> multipliers;  ///< what stands for pressure in the equations of motion, Pa
  std::vector<std::uint32_t> ids;  ///< the particle's number, never another's: in the initial
                                   ///< lattice, then in the order of coming in
  std::vector<float> boundary_pressures;  ///< of the walls' and obstacles' samples, Pa
  double last_time_step = 0;              ///< of the step that ended here, s; 0 at the start
  double allowed_time_step = 0;           ///< what that could have been had it not to end here, s
};

/// What happened between two frames, and the error measured at the second one.
struct FrameStatistics {
  int steps = 0;
  int rejected_steps = 0;
  std::int64_t iterations = 0;  ///< pressure iterations over all steps
  double min_time_step = 0;     ///< s
  double max_time_step = 0;     ///< s
  double mean_compression =
      0;  ///< mean of max(0, ρ/ρ₀ − 1) over the particles, from Frame::densities
  double max_compression = 0;   ///< largest ρ/ρ₀ − 1
  double max_speed = 0;         ///< m/s
  double kinetic_energy = 0;    ///< J
  double potential_energy = 0;  ///< J, against the domain's lowest corner along gravity
  std::int64_t contacts = 0;    ///< particles stopped by a wall's surface rather than by pressure
  double wall_work = 0;         ///< J, of obstacles that move on the liquid
  std::int64_t particles = 0;   ///< in the domain
  Exchange exchange;            ///< what came and went
};

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
