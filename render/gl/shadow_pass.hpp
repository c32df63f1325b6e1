// The floor's shadow: what stands between light and floor, slid along the light onto a map of the
// floor, and blurred as by a wide lamp. Liquid lets part of the light through.
#pragma once

#include <optional>

#include "render/gl/frame.hpp"
#include "render/gl/mesh_buffers.hpp"

namespace spindrift::gl {

class ShadowPass {
 public:
  explicit ShadowPass(const ShadowArea& area);

  /// Starts with nothing in the light's way.
  void begin() const;
  void add_liquid(const MeshBuffers& liquid);
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
  std::optional<Program> liquid_, solid_, sphere_;  ///< made when first used
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
