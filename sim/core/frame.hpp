// Particles as a run begins with them, and as it gives them out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "sim/core/exchange.hpp"

namespace spindrift::sim {

/// What became of the liquid that one volume asks for, in particles.
struct FilledVolume {
  std::size_t placed = 0;
  std::size_t outside = 0;                          ///< left out beyond the domain's faces
  std::map<std::size_t, std::size_t> in_obstacles;  ///< left out in those of the scene's obstacles
};

/// Positions, m, and velocities, m/s, of a scene's liquid at the start: its volumes, but for what
/// is outside of the domain, or taken up by an obstacle, fixed or moving.
struct InitialParticles {
  std::vector<glm::vec3> positions, velocities;
  std::vector<FilledVolume> volumes;  ///< in the order of the scene's
  std::vector<std::uint32_t> loose;   ///< particles that bodies have moved off their lattice
};

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

  /// Calls f(array) for each array of a frame that has a value per particle, in a fixed order.
  template <class AnyFrame, class F>
  static void for_each_of_particles(AnyFrame& frame, F f) {
    f(frame.positions);
    f(frame.velocities);
    f(frame.densities);
    f(frame.pressures);
    f(frame.multipliers);
    f(frame.ids);
  }

  double last_time_step = 0;     ///< of the step that ended here, s; 0 at the start
  double allowed_time_step = 0;  ///< what that could have been had it not to end here, s
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

}  // namespace spindrift::sim
