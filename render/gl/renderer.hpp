// Declares the headless renderer, which draws a liquid (mesh or particles), obstacles and the stage
// with OpenGL on EGL.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/gl/look/look.hpp"
#include "render/image.hpp"
#include "render/mesh.hpp"

namespace spindrift::gl {

/// Draws pictures; owns the OpenGL context and everything that is drawn with. It may be used from
/// one thread at a time.
class Renderer {
 public:
  /// @param width, height pixels of the pictures
  /// @param cuda_device   CUDA's number of the GPU that it computes on, which is drawn with if it
  /// can be; without one, the first device that can
  /// @throws std::runtime_error with a sentence for people when no EGL device or no OpenGL 4.5 is
  /// there, std::invalid_argument for a size that is not positive or too large for the driver
  Renderer(int width, int height, const LookSettings& look, const LightSettings& light,
           const Stage& stage, std::optional<int> cuda_device = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Sets the solid obstacles that are drawn in every picture until they are set again. A mesh
  /// without triangles removes them.
  /// @param reach points that obstacles may come to when they are set again: the shadow map covers
  /// those as well, so that its area stays the same while obstacles move, m
  /// @throws std::invalid_argument when normals are missing or an index is out of range
  void set_obstacles(const Mesh& mesh, std::span<const glm::vec3> reach = {});

  /// Draws one picture: the stage, the obstacles and the liquid.
  /// @throws std::invalid_argument when the mesh lacks normals or has an index out of range, or
  /// when there is not one attribute per particle
  Image draw(const Mesh& liquid, const View& view);
  Image draw(const ParticleCloud& liquid, const View& view);

  /// What the pictures are drawn with: the driver's strings for OpenGL's renderer, OpenGL's version
  /// and EGL's vendor, and in words which of the machine's EGL devices it is.
  struct Info {
    std::string renderer, version, egl_vendor, egl_device;
    bool software = false;  ///< whether the renderer is Mesa's llvmpipe or softpipe
  };
  const Info& info() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spindrift::gl
