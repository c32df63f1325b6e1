// Draws particles as lit spheres.
#pragma once

#include "render/gl/objects/mesh_buffers.hpp"

namespace spindrift::gl {

class ParticlePass {
 public:
  ParticlePass();
  /// Draws the particles on the bound target; attribute values from `low` to `high` run through the
  /// colour map.
  void draw(const ParticleBuffers& particles, float low, float high) const;

 private:
  Program program_;
};

}  // namespace spindrift::gl
