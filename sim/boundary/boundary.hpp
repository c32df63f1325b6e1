// Boundary particles: the walls of the domain and the obstacles, sampled by particles with volumes
// (Akinci et al. 2012, eqs. 4 and 5) and with pressures of their own (Band et al. 2018). The code
// calls them samples.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"
#include "sim/geometry/surface_sample.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// All boundary particles, sorted into the cells of a grid. Particle b is the b-th in that order.
class Boundary {
 public:
  /// Samples the domain's walls and all obstacles, sorts the boundary particles into the cells of
  /// `map` and computes the volume of each.
  /// @param radius the support radius, m
  /// @throws Stopped
  Boundary(const Settings& settings, const GridMap& map, float radius, Stop stop);

  /// Does the same with the given samples, of solids that stand among the settings' obstacles.
  Boundary(const Settings& settings, const std::vector<SurfaceSample>& unsorted, const GridMap& map,
           float radius, Stop stop);

  /// A boundary particle with all that it carries.
  struct Sample {
    Vec3<float> position;  ///< m
    float volume;          ///< m³
    float solid;           ///< density ratio that the solid behind the particle makes up for
    float wall_viscosity;  ///< Pa·s; 0 where all have the fluid's
    float pressure;        ///< Pa
    float compression;     ///< density ratio − 1 left over by the last step
    float mean_pressure;   ///< sum of pressure times time since the last frame, Pa·s
    Vec3<float> velocity;  ///< m/s
  };
  Sample sample(std::uint32_t b) const;
  /// Replaces all boundary particles by the chosen ones of `samples`, sorted into the cells of
  /// `map`: afterwards particle k is samples[chosen[grid().order()[k]]].
  void replace(Executor& executor, const Array<Sample>& samples, const Array<std::uint32_t>& chosen,
               const GridMap& map);

  std::uint32_t count() const { return count_; }
  const CellGrid& grid() const { return grid_; }
  /// The positions (m), each with its particle's volume (m³) as the value.
  PointView positions() { return position_.view(); }
  glm::vec3 position(std::uint32_t b) const { return position_.at(b); }  ///< m
  float volume(std::uint32_t b) const { return position_.value(b); }     ///< m³
  /// The density ratio that the solid behind each particle makes up for.
  float* solids() { return solid_.data(); }
  /// The wall viscosity of each particle, Pa·s; null where all have the fluid's.
  const float* wall_viscosities() const {
    return wall_viscosity_.empty() ? nullptr : wall_viscosity_.data();
  }
  /// The velocity of each particle, m/s; null where nothing moves.
  Vec3Arrays velocities() { return velocity_.view(); }
  /// The pressures of the last step, Pa.
  ScalarField& pressures() { return pressure_; }
  const ScalarField& pressures() const { return pressure_; }
  /// The sums of pressure times time since the last frame, Pa·s.
  ScalarField& mean_pressures() { return mean_pressure_; }
  /// The pressures as this step iterates them, Pa.
  ScalarField& step_pressures() { return step_pressure_; }
  /// The density ratios − 1 that the last step has left over.
  ScalarField& compressions() { return compression_; }
  std::size_t memory_bytes() const;

 private:
  void measure_volumes(const Settings& settings, const std::vector<SurfaceSample>& samples,
                       const GridMap& map, const CubicKernel& kernel, float radius, Stop stop);
  void measure_solids(const Settings& settings, const std::vector<SurfaceSample>& samples,
                      const CubicKernel& kernel, float radius, Stop stop);

  std::uint32_t count_ = 0;
  PointField position_;         ///< m, with the volumes, m³
  ScalarField solid_;           ///< density ratio that the solid behind a particle makes up for
  ScalarField pressure_;        ///< Pa; kept from step to step
  ScalarField step_pressure_;   ///< Pa; of use within a step only
  ScalarField compression_;     ///< density ratio − 1 left over by the last step
  ScalarField mean_pressure_;   ///< sum of pressure times time since the last frame, Pa·s
  ScalarField wall_viscosity_;  ///< Pa·s; empty where all have the fluid's
  VectorField velocity_;        ///< m/s; empty where nothing moves
  CellGrid grid_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
