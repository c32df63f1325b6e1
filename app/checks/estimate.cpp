#include "app/checks/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "sim/boundary/obstacle_motion.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/start/fill.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::app {
namespace {

/// Up to so many particles, volumes are filled to count them, which takes some tenths of a second.
constexpr double most_filled_particles = 2e6;

/// Larger counts are cut to this one, which an integer can hold.
constexpr double most_counted = 1e18;

// The costs below were measured on ordinary scenes and are rough by nature.
constexpr double bytes_of_particle = 450.;  // its fields and its neighbour list
constexpr double bytes_of_boundary_particle = 60.;
constexpr double bytes_of_pixel = 80.;               // 4 samples of colour and depth, two copies
constexpr double seconds_per_particle_step = 3e-6;   // of one thread
constexpr double seconds_per_particle_frame = 3e-6;  // to find the surface and draw it
constexpr double seconds_per_pixel_frame = 2.4e-7;   // to draw and write

/// The fastest speed, m/s, that the liquid is likely to reach: that of a fall through the domain's
/// height from the fastest initial speed of volumes, obstacles and emitters.
double likely_speed(const sim::Settings& settings) {
  const double gravity = glm::length(settings.forces.gravity);
  const double height = settings.domain.max.y - settings.domain.min.y;
  double start = 0.;
  for (const sim::Volume& volume : settings.fluid.volumes)
    start = std::max(start, static_cast<double>(glm::length(volume.velocity)));
  for (const sim::Obstacle& obstacle : settings.obstacles)
    start = std::max(start, static_cast<double>(sim::fastest_speed(obstacle)));
  for (const sim::Emitter& emitter : settings.fluid.emitters)
    start = std::max(start, static_cast<double>(emitter.speed));
  return std::max(std::sqrt(start * start + 2. * gravity * height), 1e-3);
}

/// The box, m, that liquid can be in: the domain and one spacing around it.
sim::Box reach_of(const sim::DomainSettings& domain, float spacing) {
  return {domain.min - spacing, domain.max + spacing};
}

/// The intersection of two boxes.
sim::Box common(const sim::Box& a, const sim::Box& b) {
  return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

/// The number of particles by the volumes' sizes, without the parts outside the domain.
double particles_by_size(const sim::Settings& settings) {
  const double edge = sim::particle_spacing(settings);
  double sum = 0.;
  for (const sim::Volume& volume : settings.fluid.volumes) {
    const sim::Box inside =
        common(sim::bounds_of(volume.shape), sim::Box{settings.domain.min, settings.domain.max});
    sum += std::min(sim::volume_of(volume.shape), sim::volume_of(inside));
  }
  return sum / (edge * edge * edge);
}

}  // namespace

double count_boundary_particles(const sim::Settings& settings) {
  const double spacing = settings.fluid.spacing;
  const sim::Box reach = reach_of(settings.domain, settings.fluid.spacing);
  double area = sim::area_of(sim::Box{settings.domain.min, settings.domain.max});
  for (const sim::Obstacle& obstacle : settings.obstacles) {
    const sim::Box bounds = sim::bounds_of(obstacle.shape);
    if (obstacle.motion || !sim::is_apart(bounds, reach))
      area += sim::area_of(obstacle.shape);
  }
  return area / (spacing * spacing);
}

double count_emitted(const sim::Settings& settings, double time) {
  double sum = 0.;
  const float spacing = sim::particle_spacing(settings);
  for (const sim::Emitter& emitter : settings.fluid.emitters) {
    const sim::Nozzle nozzle(emitter, spacing);
    sum += static_cast<double>(nozzle.entered(time)) * nozzle.layer_size();
  }
  return sum;
}

std::size_t count_particles(const sim::Settings& settings) {
  if (!is_cheap_to_fill(settings))
    return static_cast<std::size_t>(std::min(particles_by_size(settings), most_counted));
  return sim::initial_particle_count(settings);
}

bool is_cheap_to_fill(const sim::Settings& settings) {
  return particles_by_size(settings) < most_filled_particles;
}

Estimate estimate(const Scene& scene, int threads) {
  const sim::Settings& settings = scene.simulation;
  const double spacing = settings.fluid.spacing;

  Estimate result;
  const std::size_t first = count_particles(settings);
  result.particles = first + static_cast<std::size_t>(std::min(
                                 count_emitted(settings, scene.video.duration), most_counted));
  result.boundary_particles =
      static_cast<std::size_t>(std::min(count_boundary_particles(settings), most_counted));
  const auto most = static_cast<double>(result.particles);
  const double particles = 0.5 * (static_cast<double>(first) + most);  // mean over the run
  const double pixels = static_cast<double>(scene.video.width) * scene.video.height;
  result.bytes = most * bytes_of_particle +
                 static_cast<double>(result.boundary_particles) * bytes_of_boundary_particle +
                 pixels * bytes_of_pixel;

  const double frames = scene.video.frame_count();
  double step = std::min({static_cast<double>(settings.solver.max_time_step),
                          settings.solver.cfl * 2. * spacing / likely_speed(settings),
                          scene.video.frames_per_second.time_of(1)});
  if (!scene.probes.empty() && scene.probes_rate > 0)
    step = std::min(step, 1. / scene.probes_rate);
  const double steps = std::max(scene.video.duration / step, frames);
  result.seconds =
      (steps * particles * seconds_per_particle_step +
       frames * (particles * seconds_per_particle_frame + pixels * seconds_per_pixel_frame)) /
      std::max(threads, 1);
  return result;
}

}  // namespace spindrift::app
