// Scenes of the hard cases, and what is asked of every one of them: the criteria in check().
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

/// One thing that is asked of every hard case: that what is found is at most what is allowed.
struct Criterion {
  std::string limited;  ///< what it is, as docs/results.md has it
  double found, allowed;
};

/// Checks all that is asked of a run of a hard case, and records it for docs/results.md.
/// @param name of the scene, in its row there
inline void check(const std::string& name, const sim::Settings& s, const Invariants& found,
                  const Allowed& allowed = {}) {
  const bool iterates = s.solver.type == sim::SolverType::pcisph;
  const Compression& compression =
      allowed.compression_at_start ? found.compression_at_end : found.compression;
  const double compressible = allowed.sph_compression;
  const Criterion energy{
      "energy made: the largest rise over an earlier frame's energy, less the work of body forces "
      "and of walls that move, relative to what there was and was put in",
      found.energy_made, iterates ? allowed.energy : allowed.sph_energy};
  const Criterion mean{
      "mean compression, recomputed from the positions; where a scene starts too dense, in the "
      "last frame",
      compression.mean, iterates ? 1.05 * s.solver.mean_compression : compressible};
  const Criterion largest{"largest compression, likewise", compression.largest,
                          iterates ? 1.05 * s.solver.max_compression : compressible};
  const std::vector<Criterion> criteria{
      {"figures that are not finite: none", found.finite ? 0. : 1., 0},
      {"particles lost or doubled: none", found.count_kept ? 0. : 1., 0},
      {"how far a particle is outside the domain or in a solid: a millionth of the domain",
       found.outside, 1e-6 * glm::length(s.domain.max - s.domain.min)},
      energy,
      mean,
      largest,
      {"error of the energies in the statistics: 0.01 %", found.energy_off, 1e-4},
      {"error of the densities in frames and of the compressions in the statistics: 0.001 % of ρ₀",
       found.density_off, 1e-5}};
  INFO(name << ", at most " << found.max_speed << " m/s, " << found.steps << " steps");
  bool kept = true;
  for (const Criterion& c : criteria) {
    kept = kept && c.found <= c.allowed;
    record("asked | " + c.limited);
    INFO(c.limited);
    CHECK(c.found <= c.allowed);
  }
  record(fmt::format(
      "hard | {} | {} | {} | {:.2g} ({:g}) | {:.3f} ({:.3g}) | {:.2f} ({:.3g}) | {:.3g} | {} | {}",
      name, iterates ? "pcisph" : "sph", found.end.positions.size(), 100 * energy.found,
      100 * energy.allowed, 100 * mean.found, 100 * mean.allowed, 100 * largest.found,
      100 * largest.allowed, found.max_speed, found.steps, kept ? "kept" : "**not kept**"));
}

}  // namespace spindrift::test
