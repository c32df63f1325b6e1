// The scenes of the hard cases, and what is asked of each.
#pragma once

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "invariants.hpp"

namespace spindrift::test {

constexpr float d = 0.05f;  ///< spacing, m

/// An empty box of 1 m, 20 spacings.
inline sim::Settings small_scene(sim::SolverType solver) {
  sim::Settings s;
  s.solver.type = solver;
  s.fluid.spacing = d;
  s.fluid.volumes.clear();
  s.domain = {{0, 0, 0}, {1, 1, 1}};
  return s;
}

/// A column of water that breaks over a small block.
inline sim::Settings splash(sim::SolverType solver) {
  sim::Settings s = small_scene(solver);
  s.domain.max.z = 0.4f;
  s.fluid.volumes = {{sim::Box{{0, 0, 0}, {0.4f, 0.6f, 0.4f}}}};
  s.obstacles = {{sim::Box{{0.6f, 0, 0.1f}, {0.7f, 0.15f, 0.3f}}}};
  return s;
}

/// Two jets along x that meet in the middle, at 20 m/s each.
inline sim::Settings jets(sim::SolverType solver) {
  sim::Settings s = small_scene(solver);
  s.domain = {{-1, -0.8f, -0.8f}, {1, 0.8f, 0.8f}};
  s.fluid.volumes = {
      {sim::Cylinder{{-0.9f, 0, 0}, {-0.1f, 0, 0}, 0.15f}, {20, 0, 0}},
      {sim::Cylinder{{0.1f, 0.01f, 0.02f}, {0.9f, 0.01f, 0.02f}, 0.15f}, {-20, 0, 0}}};
  return s;
}

/// Two blocks, 10 spacings wide, with 3 of them in common.
inline sim::Settings overlap(sim::SolverType solver) {
  sim::Settings s = small_scene(solver);
  s.fluid.volumes = {{sim::Box{{0, 0, 0.3f}, {10 * d, 6 * d, 0.6f}}},
                     {sim::Box{{7.2f * d, 0.3f * d, 0.31f}, {17.2f * d, 6.3f * d, 0.61f}}}};
  return s;
}

/// A column of 5 × 100 × 5 particles in a shaft `width` wide, m.
inline sim::Settings column(sim::SolverType solver, float width) {
  sim::Settings s = small_scene(solver);
  s.domain = {{0, 0, 0}, {width, 105 * d, width}};
  const float low = std::round(0.5f * (width / d - 5)) * d;
  s.fluid.volumes = {{sim::Box{{low, 0, low}, {low + 5 * d, 100 * d, low + 5 * d}}}};
  return s;
}

/// What a scene may do, beyond what is asked of all.
struct Allowed {
  double energy = 0.005;              ///< made, relative to what there was and was put in
  bool compression_at_start = false;  ///< it starts too dense: only its end counts
  /// With basic SPH: the elastic energy in the walls' samples is not counted.
  double sph_energy = 0.02;
  double sph_compression = 0.1;  ///< largest with basic SPH, whose water is compressible, ρ/ρ₀ − 1
};

inline void check(const std::string& name, const sim::Settings& s, const Invariants& found,
                  const Allowed& allowed = {}) {
  const bool iterates = s.solver.type == sim::SolverType::pcisph;
  const Compression& compression =
      allowed.compression_at_start ? found.compression_at_end : found.compression;
  const double largest = compression.largest, mean = compression.mean;
  const double energy = iterates ? allowed.energy : allowed.sph_energy;
  const double most = iterates ? 1.05 * s.solver.max_compression : allowed.sph_compression;
  const double most_mean = iterates ? 1.05 * s.solver.mean_compression : most;
  const double beyond = 1e-6 * glm::length(s.domain.max - s.domain.min);
  const bool kept = found.finite && found.count_kept && found.outside <= beyond &&
                    found.energy_made <= energy && largest <= most && mean <= most_mean;
  record(fmt::format(
      "hard | {} | {} | {} | {:.2g} ({:g}) | {:.3f} | {:.2f} ({:.3g}) | {:.3g} | {} | {}", name,
      iterates ? "pcisph" : "sph", found.end.positions.size(), 100 * found.energy_made,
      100 * energy, 100 * mean, 100 * largest, 100 * most, found.max_speed, found.steps,
      kept ? "kept" : "**not kept**"));
  INFO(name << ", at most " << found.max_speed << " m/s, " << found.steps << " steps");
  CHECK(found.finite);
  CHECK(found.count_kept);
  CHECK(found.outside <= beyond);
  CHECK(found.energy_made <= energy);
  CHECK(found.energy_off < 1e-4);
  CHECK(found.density_off < 1e-5);
  CHECK(largest <= most);
  CHECK(mean <= most_mean);
}

}  // namespace spindrift::test
