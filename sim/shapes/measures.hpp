// Volumes and areas of shapes.
#pragma once

#include "sim/settings.hpp"

namespace spindrift::sim {

/// Volume of a shape, m³; of a mesh whose parts overlap, the sum of theirs.
double volume_of(const Shape& shape);

/// Area of a shape's surface, m².
double area_of(const Shape& shape);

/// Area of an emitter's opening, m².
double area_of(const Opening& opening);

}  // namespace spindrift::sim
