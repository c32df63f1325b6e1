#include "app/draw/scene_drawing.hpp"

#include "app/scene/camera.hpp"
#include "render/surface/surface.hpp"
#include "sim/start/fill.hpp"

namespace spindrift::app {
namespace {

/// The values, one per particle, by which the particles are coloured.
std::vector<float> attribute_of(const sim::Frame& frame, gl::ColorBy color_by) {
  switch (color_by) {
    case gl::ColorBy::density:
      return frame.densities;
    case gl::ColorBy::pressure:
      return frame.pressures;
    case gl::ColorBy::speed:
      break;
  }
  std::vector<float> speeds;
  speeds.reserve(frame.velocities.size());
  for (const glm::vec3 v : frame.velocities)
    speeds.push_back(glm::length(v));
  return speeds;
}

}  // namespace

SceneDrawing::SceneDrawing(const Scene& scene, std::optional<int> cuda_device)
    : scene_(scene),
      renderer_(scene.video.width, scene.video.height, scene.look, scene.light,
                gl::Stage{scene.simulation.domain.min, scene.simulation.domain.max}, cuda_device),
      obstacles_(scene.simulation.obstacles) {
  std::vector<double> instants;  // times of all pictures of the scene, even if only some are drawn
  for (int k = 0; obstacles_.move() && k < scene.video.frame_count(); ++k)
    instants.push_back(scene.video.frames_per_second.time_of(k));
  reach_ = obstacles_.reach(instants);
  if (!obstacles_.empty())
    renderer_.set_obstacles(obstacles_.at(0), reach_);
}

Mesh SceneDrawing::surface_of(const sim::Frame& frame) const {
  return surface::reconstruct_surface(frame.positions, sim::particle_spacing(scene_.simulation),
                                      scene_.surface);
}

Image SceneDrawing::draw(const sim::Frame& frame, const Mesh& surface) {
  const float aspect =
      static_cast<float>(scene_.video.width) / static_cast<float>(scene_.video.height);
  const gl::View view = view_at(scene_.camera, scene_.simulation.domain, aspect, frame.time);
  if (obstacles_.move())
    renderer_.set_obstacles(obstacles_.at(frame.time), reach_);
  if (shows_surface())
    return renderer_.draw(surface, view);
  const std::vector<float> attribute = attribute_of(frame, scene_.look.color_by);
  return renderer_.draw(
      gl::ParticleCloud{.positions = frame.positions,
                        .attribute = attribute,
                        .radius = scene_.look.particle_radius * scene_.simulation.fluid.spacing},
      view);
}

}  // namespace spindrift::app
