// Draws the shadow on the floor: what stands between light and floor is slid along the light onto a
// map of the floor, and blurred as by a wide lamp. Liquid lets part of the light through.
#pragma once

#include <optional>

#include "render/gl/look/frame.hpp"
#include "render/gl/objects/mesh_buffers.hpp"
#include "render/gl/passes/shadow_splat.hpp"

namespace spindrift::gl {

/// Draws the shadow map: between begin() and finish(), all that stands in the light's way is added.
class ShadowPass {
 public:
  /// @param area  part of the floor that the map covers; not empty
  /// @param light unit direction in which the light travels
  /// @param floor height of the floor, m
  ShadowPass(const ShadowArea& area, glm::vec3 light, float floor);

  /// Starts a map with the surface of the liquid in the light's way, or with nothing if it is null.
  void begin(const Mesh* liquid);
  /// Adds the particles of a liquid.
  void add_particles(const ParticleBuffers& particles);
  /// Adds opaque obstacles.
  void add_obstacles(const MeshBuffers& obstacles);
  /// Blurs the map and returns it: the share of the light that arrives on the floor, as linear RGB.
  const Texture& finish() const;

 private:
  struct Target {
    Target(GLenum format, int width, int height);
    Texture texture;
    Framebuffer framebuffer;
  };

  int width_, height_;
  Target blocked_, half_blurred_, arriving_;
  Program blur_;
  ShadowSplat splat_;
  std::optional<Program> solid_, sphere_;  ///< made when first used
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
