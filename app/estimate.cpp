#include "app/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "app/closed_surface.hpp"
#include "sim/initial.hpp"
#include "sim/motion.hpp"
#include "sim/nozzle.hpp"
#include "sim/shapes/mesh_body.hpp"
#include "sim/simulation.hpp"

namespace spindrift::app {
namespace {

using std::numbers::pi;

// Measured on ordinary scenes; rough by nature.
constexpr double bytes_per_particle = 450.;  // its fields and its neighbour list
constexpr double bytes_per_boundary_particle = 60.;
constexpr double bytes_per_pixel = 80.;              // 4 samples of colour and depth, two copies
constexpr double seconds_per_particle_step = 3e-6;   // of one thread
constexpr double seconds_per_particle_frame = 3e-6;  // to find the surface and draw it
constexpr double seconds_per_pixel_frame = 2.4e-7;   // to draw and write

/// The fastest speed that falling through the domain and the volumes' own speeds give.
double likely_speed(const sim::Settings& settings) {
  const double gravity = glm::length(settings.forces.gravity);
  const double height = settings.domain.max.y - settings.domain.min.y;
  double start = 0.;
  for (const sim::Volume& volume : settings.fluid.volumes) {
    start = std::max(start, static_cast<double>(glm::length(volume.velocity)));
  }
  for (const sim::Obstacle& obstacle : settings.obstacles) {
    start = std::max(start, static_cast<double>(sim::fastest_speed(obstacle)));
  }
  for (const sim::Emitter& emitter : settings.fluid.emitters) {
    start = std::max(start, static_cast<double>(emitter.speed));
  }
  return std::max(std::sqrt(start * start + 2. * gravity * height), 1e-3);
}

double volume(const sim::Box& box) {
  const glm::dvec3 d = glm::dvec3(box.max) - glm::dvec3(box.min);
  return d.x * d.y * d.z;
}
double area(const sim::Box& box) {
  const glm::dvec3 d = glm::dvec3(box.max) - glm::dvec3(box.min);
  return 2. * (d.x * d.y + d.y * d.z + d.z * d.x);
}

double volume(const sim::Sphere& sphere) {
  return 4. / 3. * pi * std::pow(static_cast<double>(sphere.radius), 3);
}
double area(const sim::Sphere& sphere) {
  return 4. * pi * std::pow(static_cast<double>(sphere.radius), 2);
}

template <class Shape>
double length(const Shape& shape) {
  return glm::distance(glm::dvec3(shape.from), glm::dvec3(shape.to));
}

double volume(const sim::Cylinder& cylinder) {
  const double radius = cylinder.radius;
  return pi * radius * radius * length(cylinder);
}
double area(const sim::Cylinder& cylinder) {
  const double radius = cylinder.radius;
  return 2. * pi * radius * (radius + length(cylinder));
}

double volume(const sim::Capsule& capsule) {
  const double radius = capsule.radius;
  return pi * radius * radius * (length(capsule) + 4. / 3. * radius);
}
double area(const sim::Capsule& capsule) {
  const double radius = capsule.radius;
  return 2. * pi * radius * (length(capsule) + 2. * radius);
}

double volume(const sim::TriangleMesh& mesh) {
  return enclosed_volume(mesh.body->surface());
}
double area(const sim::TriangleMesh& mesh) {
  const sim::TriangleSurface& surface = mesh.body->surface();
  double sum = 0.;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

/// Particles that come out of emitters until a time, s, where nothing is in their way.
std::size_t entered_until(const sim::Settings& settings, double time) {
  std::size_t sum = 0;
  for (const sim::Emitter& emitter : settings.fluid.emitters) {
    const sim::Nozzle nozzle(emitter, settings.fluid.spacing);
    sum += static_cast<std::size_t>(nozzle.entered(time)) * nozzle.layer_size();
  }
  return sum;
}

}  // namespace

double shape_volume(const sim::Shape& shape) {
  return std::visit([](const auto& s) { return volume(s); }, shape);
}

double opening_area(const sim::Opening& opening) {
  if (const auto* disc = std::get_if<sim::Disc>(&opening)) {
    return pi * std::pow(static_cast<double>(disc->radius), 2);
  }
  const auto& rectangle = std::get<sim::Rectangle>(opening);
  return static_cast<double>(rectangle.width) * rectangle.height;
}

double shape_area(const sim::Shape& shape) {
  return std::visit([](const auto& s) { return area(s); }, shape);
}

Estimate estimate(const Scene& scene, int threads) {
  const sim::Settings& settings = scene.simulation;
  const double spacing = settings.fluid.spacing;
  double solid_area = area(sim::Box{settings.domain.min, settings.domain.max});
  for (const sim::Obstacle& obstacle : settings.obstacles) {
    solid_area += shape_area(obstacle.shape);
  }

  Estimate result;
  const std::size_t first = sim::fill_volumes(settings).positions.size();
  result.particles = first + entered_until(settings, scene.video.duration);
  result.boundary_particles = static_cast<std::size_t>(solid_area / (spacing * spacing));
  const auto most = static_cast<double>(result.particles);
  const double particles = 0.5 * (static_cast<double>(first) + most);  // over the time
  const double pixels = static_cast<double>(scene.video.width) * scene.video.height;
  result.bytes = most * bytes_per_particle +
                 static_cast<double>(result.boundary_particles) * bytes_per_boundary_particle +
                 pixels * bytes_per_pixel;

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
