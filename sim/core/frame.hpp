// The particles that a run starts with, and the frames and statistics that it gives out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/core/exchange.hpp"

namespace spindrift::sim {

/// How many particles of one volume of the scene are placed, and how many left out.
struct FilledVolume {
  std::size_t placed = 0;
  std::size_t outside = 0;  ///< particles left out since they lie beyond the domain's faces
  /// Particles left out since an obstacle takes their place, by the obstacle's index in the scene.
  std::map<std::size_t, std::size_t> in_obstacles;
};

/// The particles of a scene's liquid at the start: they fill its volumes, but for what is outside
/// the domain or taken up by an obstacle, fixed or moving.
struct InitialParticles {
  std::vector<glm::vec3> positions, velocities;  ///< one per particle, m and m/s
  std::vector<FilledVolume> volumes;             ///< one per volume, in the scene's order
  std::vector<std::uint32_t> loose;  ///< indices of particles moved off their lattice near bodies
};

/// What a value of a frame's particles is good for outside of the simulation.
enum class FieldUse {
  shown,     ///< it is exported
  identity,  ///< it is exported where particles come and go
  internal   ///< it is there to go on from the frame
};

/// One of the arrays of a frame that have a value per particle.
template <class Member>
struct FrameField {
  std::string_view properties;  ///< names of its numbers in files, as "vx vy vz"
  std::string_view unit;        ///< in letters and digits, as kg/m^3
  FieldUse use;
  Member member;  ///< of Frame
};
template <class Member>
FrameField(std::string_view, std::string_view, FieldUse, Member) -> FrameField<Member>;

/// Particle data at one instant, with one value per particle in the solver's order. With the time
/// step sizes they are all that a run needs to go on from here to the same bytes.
struct Frame {
  double time = 0;                   ///< s
  std::vector<glm::vec3> positions;  ///< m
  /// Velocities over the step that ended here (leapfrog: at its middle), m/s.
  std::vector<glm::vec3> velocities;
  /// Densities recomputed from the positions with the full neighbourhood, kg/m³.
  std::vector<float> densities;
  /// Mechanical pressures (mechanical_pressure() in formulas.hpp), means since the last frame, Pa.
  std::vector<float> pressures;
  /// What stood for the pressures in the equations of motion of the last step, Pa: with PCISPH,
  /// multipliers of the density constraint ρ ≤ ρ₀, from which the next step's iteration starts.
  std::vector<float> constraint_multipliers;
  /// Numbers of the particles, each given once in a run: first in the initial lattice's order, then
  /// in the order in which particles come in.
  std::vector<std::uint32_t> ids;
  /// Pressures of the boundary particles of walls and obstacles, Pa, not one per fluid particle.
  std::vector<float> boundary_pressures;

  /// All arrays with a value per particle. What is done to all of them is driven by this list.
  static constexpr auto fields =
      std::tuple{FrameField{"x y z", "m", FieldUse::shown, &Frame::positions},
                 FrameField{"vx vy vz", "m/s", FieldUse::shown, &Frame::velocities},
                 FrameField{"density", "kg/m^3", FieldUse::shown, &Frame::densities},
                 FrameField{"pressure", "Pa", FieldUse::shown, &Frame::pressures},
                 FrameField{"multiplier", "Pa", FieldUse::internal, &Frame::constraint_multipliers},
                 FrameField{"id", "", FieldUse::identity, &Frame::ids}};

  /// Calls f(field) for each of them, in their order.
  template <class F>
  static void for_each_field(F f) {
    std::apply([&](const auto&... field) { (f(field), ...); }, fields);
  }

  /// Calls f(array) for each of them.
  template <class AnyFrame, class F>
  static void for_each_of_particles(AnyFrame& frame, F f) {
    for_each_field([&](const auto& field) { f(frame.*field.member); });
  }

  double last_time_step = 0;     ///< size of the step that ended here, s; 0 at the start
  double allowed_time_step = 0;  ///< size it could have had without having to end here, s
};

/// What happened between two frames, and the error measured at the second one.
struct FrameStatistics {
  int steps = 0;
  int rejected_steps = 0;       ///< steps repeated with a smaller time step size
  std::int64_t iterations = 0;  ///< pressure iterations over all steps
  double min_time_step = 0;     ///< s
  double max_time_step = 0;     ///< s
  /// Mean of max(0, ρ/ρ₀ − 1) over the particles, from Frame::densities.
  double mean_compression = 0;
  double max_compression = 0;   ///< largest ρ/ρ₀ − 1
  double max_speed = 0;         ///< m/s
  double kinetic_energy = 0;    ///< J
  double potential_energy = 0;  ///< relative to the domain's lowest corner along gravity, J
  std::int64_t contacts = 0;    ///< times that a surface, not pressure, stopped a particle
  double wall_work = 0;         ///< work of moving obstacles on the liquid, J
  std::int64_t particles = 0;   ///< number of particles at the second frame
  Exchange exchange;
};

}  // namespace spindrift::sim
