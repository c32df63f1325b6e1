// What measuring instruments in a tank would read, from the particles at one instant.
//
// Samples of walls and obstacles take no part: near them the formulas see particles only, and, at
// the domain's upright walls, their mirror images where that is said. Liquid behind an obstacle is
// not seen.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/run/sight.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::sim {

/// Height of the free surface on the vertical through a point.
struct SurfaceHeightProbe {
  float x = 0.f;  ///< m
  float z = 0.f;  ///< m
};

/// Pressure at a point.
struct PressureProbe {
  glm::vec3 point{0.f};  ///< m
};

/// How far the liquid has come.
struct FrontProbe {
  Direction direction = Direction::plus_x;  ///< the way it goes
};

/// Energies of the whole liquid.
struct EnergyProbe {};

/// Volume of the liquid and the box around it.
struct VolumeProbe {};

using ProbeQuantity =
    std::variant<SurfaceHeightProbe, PressureProbe, FrontProbe, EnergyProbe, VolumeProbe>;

struct Probe {
  std::string name;  ///< of its columns
  ProbeQuantity quantity;
};

/// What a probe measures: one of its numbers.
struct ProbeColumn {
  std::string name;       ///< the probe's, and which of its numbers
  std::string_view unit;  ///< in letters and digits, as m3 for m³
};

std::vector<ProbeColumn> probe_columns(const Probe& probe);

/// A probe's numbers, one for each of its columns; NaN where there is nothing to measure.
std::vector<double> measure(const Probe& probe, const Frame& frame, const Settings& settings);

/// Height y (m) at which, coming from above on the vertical through (x, z), the liquid's part of
/// space, V Σⱼ W(x − xⱼ) with the cubic kernel of 2 spacings, reaches one half: the value on a flat
/// surface half a spacing above the topmost particles. A particle alone reaches 0.32, two no more
/// than 0.46, so that drops are not taken for the surface. The domain's upright walls mirror the
/// particles. NaN where no liquid is.
/// @param sight from the vertical to particles at the same height
double surface_height(const Frame& frame, float spacing, const DomainSettings& domain, float x,
                      float z, const Sight& sight = {});

/// Mean of the particles' pressures, Pa, with the cubic kernel's weights (Shepard 1968) over 2
/// spacings around the point; 0, the pressure of the air, where no particle is. At a wall all
/// particles lie on one side, on average half a spacing off it.
double pressure_at(const Frame& frame, float spacing, const glm::vec3& point,
                   const Sight& sight = {});

/// Coordinate (m) along the direction's axis of the foremost particle that has five others at least
/// closer than 2 spacings, as the edge of a layer one particle thick has, and half a spacing more:
/// drops of up to five particles that fly ahead are left out. NaN where all is drops.
double front_position(const Frame& frame, float spacing, Direction direction);

struct Energy {
  double kinetic = 0;  ///< J; velocities are those over the last step
  double potential =
      0;  ///< J, in the field of gravity, against the domain's lowest corner along it
};
Energy energy_of(const Frame& frame, const Settings& settings);

struct Extent {
  double volume = 0;          ///< m³: what a particle has in a full lattice, times their number
  glm::dvec3 min{0}, max{0};  ///< m: half a spacing around the outermost particles' centres
};
Extent extent_of(const Frame& frame, float spacing);

}  // namespace spindrift::sim
