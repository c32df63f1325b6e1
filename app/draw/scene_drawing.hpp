// Draws the pictures of a scene from its particles.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/draw/obstacle_mesh.hpp"
#include "app/scene/scene.hpp"
#include "render/gl/renderer.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// Owns the renderer and the obstacle meshes of a scene. It must be used by a single thread, since
/// its GL context belongs to one.
class SceneDrawing {
 public:
  /// @param scene must outlive this object
  /// @param cuda_device passed on to gl::Renderer
  /// @throws std::runtime_error where no renderer can be set up
  explicit SceneDrawing(const Scene& scene, std::optional<int> cuda_device = {});

  const gl::Renderer::Info& info() const { return renderer_.info(); }

  /// Whether the look shows the liquid's surface rather than its particles.
  bool shows_surface() const { return scene_.look.style == gl::Style::mesh; }

  /// Reconstructs the liquid's surface with the scene's surface settings.
  Mesh surface_of(const sim::Frame& frame) const;

  /// Draws the picture of a frame.
  /// @param surface the liquid's surface in the frame; ignored where the look shows particles
  Image draw(const sim::Frame& frame, const Mesh& surface);

 private:
  const Scene& scene_;
  gl::Renderer renderer_;
  ObstacleMeshes obstacles_;
  std::vector<glm::vec3> reach_;  ///< corners of the box that moving obstacles stay within, m
};

}  // namespace spindrift::app
