// A scene's pictures, drawn from its particles.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/draw/obstacle_mesh.hpp"
#include "app/scene/scene.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// Owns what a scene is drawn with; it belongs to one thread, since a GL context does.
class SceneDrawing {
 public:
  /// @param scene must live as long as this
  /// @param cuda_device as gl::Renderer's
  /// @throws std::runtime_error where nothing can draw
  explicit SceneDrawing(const Scene& scene, std::optional<int> cuda_device = {});

  const gl::Renderer::Info& info() const { return renderer_.info(); }

  /// The look shows the liquid's surface, not its particles.
  bool shows_surface() const { return scene_.look.style == gl::Style::mesh; }

  /// The liquid's surface, as the scene wants it.
  Mesh surface_of(const sim::Frame& frame) const;

  /// The picture at a frame's time. @param surface the frame's; not looked at where the look shows
  /// particles
  Image draw(const sim::Frame& frame, const Mesh& surface);

 private:
  const Scene& scene_;
  gl::Renderer renderer_;
  ObstacleMeshes obstacles_;
  std::vector<glm::vec3> reach_;  ///< corners of the space that moving obstacles pass through
};

}  // namespace spindrift::app
