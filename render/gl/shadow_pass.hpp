// The floor's shadow: what stands between light and floor, slid along the light onto a map of the
// floor, and blurred as by a wide lamp. Liquid lets part of the light through.
#pragma once

#include <optional>

#include "render/gl/frame.hpp"
#include "render/gl/mesh_buffers.hpp"
#include "render/gl/shadow_splat.hpp"

namespace spindrift::gl {

class ShadowPass {
 public:
  ShadowPass(const ShadowArea& area, glm::vec3 light, float floor);

  /// Starts with the liquid in the light's way (null: nothing).
  void begin(const Mesh* liquid);
  void add_particles(const ParticleBuffers& particles);
  void add_obstacles(const MeshBuffers& obstacles);
  /// Share of the light that arrives on the floor, over the shadow area.
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
