#include "sim/pressure/settle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "sim/pressure/pcisph.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Number of sweeps after which the liquid is taken to find no rest.
constexpr int most_sweeps = 400;

/// Number of sweeps at an arrival, after which the rest is left to the steps.
constexpr int most_sweeps_at_arrival = 20;

/// Share of the compression that a sweep may leave; it grows where a sweep is refused.
constexpr float left_by_a_sweep = 0.5f;

/// Particles closer than this many spacings have no direction in which to part.
constexpr float same_place = 0.01f;

/// Compression max(0, ρ/ρ₀ − 1) of the particles.
struct Compression {
  double sum = 0;
  float largest = 0;
  Vec3<float> where{};  ///< position of the particle with the largest, m
  SPINDRIFT_HD void join(const Compression& o) {
    sum += o.sum;
    if (o.largest > largest) {
      largest = o.largest;
      where = o.where;
    }
  }
};

/// The error message for liquid that finds no rest.
std::string no_rest(const Compression& left, std::uint32_t count, const SolverSettings& settings) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(),
                "the liquid finds no rest before time begins: after %d rounds of moving particles "
                "apart it is compressed by %.3g %% on average and by %.3g %% near [%.3g, %.3g, "
                "%.3g], and by %.3g %% and %.3g %% it may be. Where volumes overlap or reach into "
                "walls, make them smaller or the domain larger; else raise "
                "solver.mean_compression or solver.max_compression",
                most_sweeps, 100 * left.sum / count, 100. * left.largest, left.where.x,
                left.where.y, left.where.z, 100. * settings.mean_compression,
                100. * settings.max_compression);
  return text.data();
}

/// A direction that depends on the particle's id alone (golden-angle spiral on the sphere).
SPINDRIFT_HD Vec3<float> direction_of(std::uint32_t id) {
  const double z = 1 - 2 * std::fmod(0.5 + 0.6180339887498949 * id, 1.);
  const double angle = 2.399963229728653 * id, across = std::sqrt(1 - z * z);
  return {static_cast<float>(across * std::cos(angle)),
          static_cast<float>(across * std::sin(angle)), static_cast<float>(z)};
}

/// Whether particle i is in a nozzle, which moves it.
SPINDRIFT_HD bool is_held(const float* held, std::uint32_t i) {
  return held != nullptr && held[i] > 0;
}

/// The sweeps of settle(), whose arguments it holds.
struct Settling {
  Executor& executor;
  Particles& particles;
  Neighbourhood& neighbourhood;
  const Inflow& inflow;
  const FluidConstants& constants;
  const SolverSettings& settings;
  const GridMap& map;
  const ContactView& contact;
  float radius;
  Occasion occasion;
  std::unique_ptr<PcisphSolver> solver = make_pcisph(settings, constants);

  /// Sweeps until the compression is within the tolerances; returns the number of sweeps.
  int run() {
    const bool arrival = occasion == Occasion::arrival;
    if (!arrival)
      place_alone();
    const int most = arrival ? most_sweeps_at_arrival : most_sweeps;
    for (int sweep = 0; sweep < most; ++sweep) {
      const Compression found = compression();
      if (found.largest <= settings.max_compression &&
          (arrival || found.sum <= double{settings.mean_compression} * particles.count))
        return sweep;
      part_coincident();
      ease(1 + found.largest);
    }
    if (!arrival)
      throw std::invalid_argument(no_rest(compression(), particles.count, settings));
    return most;
  }

  void find_neighbours() {
    const Vec3Arrays x = particles.position.view();
    const PointView at = particles.drifted_position.view();
    executor.for_each("settle", particles.count,
                      [=] SPINDRIFT_HD(std::uint32_t i) { at.set(i, x[i]); });
    neighbourhood.update(executor, particles, radius);
  }

  /// The compression of all particles, which it writes to Particles::compression.
  Compression compression() {
    find_neighbours();
    const CubicKernel kernel(constants.support_radius);
    const PointView position = particles.drifted_position.view();
    const NeighbourView neighbours = neighbourhood.fluid();
    const BoundaryView solid = neighbourhood.boundary();
    float* above = particles.compression.resized(particles.count);
    const float* held = inflow.held(particles);
    const FluidConstants c = constants;
    const bool held_too = occasion == Occasion::arrival;
    const auto measure_one = [=] SPINDRIFT_HD(std::uint32_t i) {
      above[i] = !held_too && is_held(held, i)
                     ? 0
                     : std::max(0.f, density_ratio(i, c, kernel, position, neighbours, solid) - 1);
      return Compression{above[i], above[i], position[i]};
    };
    return executor.reduce<Compression>("settle", particles.count, measure_one);
  }

  /// Puts particles without neighbours as far off the walls as liquid at rest lies.
  void place_alone() {
    find_neighbours();
    const Vec3Arrays x = particles.position.view();
    const NeighbourView neighbours = neighbourhood.fluid();
    const float* held = inflow.held(particles);
    const std::uint32_t n = particles.count;
    const ContactView walls = contact;
    const float distance = 0.5f * constants.spacing;
    executor.for_each("settle", n, [=] SPINDRIFT_HD(std::uint32_t i) {
      if (neighbours.is_alone(i, n) && !is_held(held, i))
        x.set(i, walls.resolve_off_walls(x[i], x[i], distance));
    });
  }

  /// Moves particles apart that coincide: pressure cannot, since the gradient of a kernel is zero
  /// at its centre.
  void part_coincident() {
    const Vec3Arrays x = particles.position.view();
    const PointView at = particles.drifted_position.view();
    const NeighbourView neighbours = neighbourhood.fluid();
    const float near = same_place * constants.spacing;
    const float* held = inflow.held(particles);
    const ContactView walls = contact;
    const std::uint32_t* ids = particles.ids.data();
    executor.for_each("settle", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
      const Vec3<float> xi = at[i];
      const float count = neighbours.sum(i, [&](auto j) {
        const auto d = xi - at[j];
        return dot(d, d) < near * near ? 1.f + 0.f * d.x : 0.f * d.x;
      });
      if (count > 1.5f && !is_held(held, i))
        x.set(i, walls.resolve(xi, xi + 5 * near * direction_of(ids[i])));
    });
    find_neighbours();
  }

  /// One sweep: moves the particles by a pressure solve that leaves a share of the compression.
  /// @param densest largest density ratio
  void ease(float densest) {
    const Vec3Arrays x = particles.position.view();
    const std::uint32_t n = particles.count;
    float* excess = particles.excess.resized(n);
    const float* above = particles.compression.data();
    float* pressure = particles.pressure.data();
    int refusals = 0;
    for (float part = left_by_a_sweep;; part = 0.5f * (1 + part), ++refusals) {
      executor.for_each("settle", n, [=] SPINDRIFT_HD(std::uint32_t i) {
        excess[i] = part * above[i];
        pressure[i] = 0;
      });
      const StepResult result =
          solver->solve({.executor = executor,
                         .particles = particles,
                         .constants = constants,
                         .neighbours = neighbourhood.fluid(),
                         .boundary = neighbourhood.boundary(),
                         .grid = neighbourhood.grid(),
                         .map = &map,
                         .contact = contact,
                         .held = inflow.held(particles),
                         .duration = settings.max_time_step,
                         .refusals = refusals,
                         .kick = settings.max_time_step,
                         .acceleration = 0},
                        {.excess = excess, .settling = true, .densest = densest});
      // Where no share is accepted, a small part of too large a correction is better than none.
      if (result.accepted || part >= 0.99f)
        break;
    }
    const PointView corrected = particles.corrected_position.view();
    executor.for_each("settle", n, [=] SPINDRIFT_HD(std::uint32_t i) { x.set(i, corrected[i]); });
  }
};

}  // namespace

int settle(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
           const Inflow& inflow, const FluidConstants& constants, const SolverSettings& settings,
           const GridMap& map, const ContactView& contact, float radius, Occasion occasion) {
  return Settling{executor, particles, neighbourhood, inflow, constants,
                  settings, map,       contact,       radius, occasion}
      .run();
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
