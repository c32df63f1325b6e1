// Walls and obstacles as particles with volumes (Akinci et al. 2012, eqs. 4 and 5) and with
// pressures of their own (Band et al. 2018).
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"
#include "sim/geometry/surface_sample.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Boundary {
 public:
  /// Samples the domain's walls and all obstacles, sorts the samples into the cells of `map` and
  /// gives each its volume. `radius` is the support radius, m. @throws Stopped
  Boundary(const Settings& settings, const GridMap& map, float radius, Stop stop);

  /// The same with samples that are given, of a solid whose surroundings are the settings'.
  Boundary(const Settings& settings, const std::vector<SurfaceSample>& samples, const GridMap& map,
           float radius, Stop stop);

  /// A sample and what it carries.
  struct Sample {
    Vec3<float> position;  ///< m
    float volume;          ///< m³
    float solid;
    float wall_viscosity;  ///< Pa·s
    float pressure;        ///< Pa
    float compression;     ///< left over by the last step
    float mean_pressure;   ///< Pa·s
    Vec3<float> velocity;  ///< m/s
  };
  Sample sample(std::uint32_t b) const;
  /// Takes the chosen ones of these samples in place of those there are, sorted into the cells of
  /// `map`: sample k is the one whose number is chosen[grid().order()[k]].
  void replace(Executor& executor, const Array<Sample>& samples, const Array<std::uint32_t>& chosen,
               const GridMap& map);

  std::uint32_t count() const { return count_; }
  const CellGrid& grid() const { return grid_; }
  /// With the volumes, m³.
  PointView positions() { return position_.view(); }
  glm::vec3 position(std::uint32_t b) const { return position_.at(b); }  ///< m
  float volume(std::uint32_t b) const { return position_.value(b); }     ///< m³
  float* solids() { return solid_.data(); }
  /// Pa·s; null where all have the fluid's.
  const float* wall_viscosities() const {
    return wall_viscosity_.empty() ? nullptr : wall_viscosity_.data();
  }
  /// m/s; null where nothing moves.
  Vec3Arrays velocities() { return velocity_.view(); }
  ScalarField& pressures() { return pressure_; }
  const ScalarField& pressures() const { return pressure_; }
  ScalarField& mean_pressures() { return mean_pressure_; }
  ScalarField& step_pressures() { return step_pressure_; }
  ScalarField& compressions() { return compression_; }
  std::size_t memory_bytes() const;

 private:
  void measure_volumes(const Settings& settings, const std::vector<SurfaceSample>& samples,
                       const GridMap& map, const CubicKernel& kernel, float radius, Stop stop);
  void measure_solids(const Settings& settings, const std::vector<SurfaceSample>& samples,
                      const CubicKernel& kernel, float radius, Stop stop);

  std::uint32_t count_ = 0;
  PointField position_;         ///< m, with the volumes, m³
  ScalarField solid_;           ///< density ratio that the solid behind a sample makes up for
  ScalarField pressure_;        ///< Pa, lasts from step to step
  ScalarField step_pressure_;   ///< Pa, within a step
  ScalarField compression_;     ///< left over by the last step
  ScalarField mean_pressure_;   ///< sum of pressure times time since the last frame, Pa·s
  ScalarField wall_viscosity_;  ///< Pa·s; empty where all have the fluid's
  VectorField velocity_;        ///< m/s; empty where nothing moves
  CellGrid grid_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
