// What a scene will cost, without simulating it.
#pragma once

#include <cstddef>

#include "app/scene.hpp"

namespace spindrift::app {

struct Estimate {
  std::size_t particles = 0;           ///< exact; where emitters bring more, the most there can be
  std::size_t boundary_particles = 0;  ///< one layer on every wall and obstacle, roughly
  double bytes = 0.;                   ///< memory, roughly
  double seconds = 0.;  ///< wall clock of the whole command, within a factor of three
};

/// @param threads that share the work
Estimate estimate(const Scene& scene, int threads);

/// Volume of a shape, m³.
double shape_volume(const sim::Shape& shape);

/// Area of an emitter's opening, m².
double opening_area(const sim::Opening& opening);

/// Area of a shape's surface, m².
double shape_area(const sim::Shape& shape);

}  // namespace spindrift::app
