// What must hold in every scene, however hard: measured over a run, frame by frame.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "plain_densities.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"
#include "sim/step/time_step.hpp"

namespace spindrift::test {

/// By how much liquid is denser than at rest.
struct Compression {
  double mean = 0;     ///< of max(0, ρ/ρ₀ − 1) over the particles
  double largest = 0;  ///< largest ρ/ρ₀ − 1, or 0
};

/// The worst figures of a run.
struct Invariants {
  bool finite = true;       ///< every position, velocity, density and pressure
  bool count_kept = true;   ///< every id once
  double outside = 0;       ///< farthest that a particle is outside the domain or in a solid, m
  double energy_start = 0;  ///< J, kinetic and potential
  double wall_work = 0;     ///< J, of obstacles that move
  double energy_made =
      0;  ///< largest rise of the energy over an earlier frame's, less the work of
          ///< body forces and moving walls, relative to what there was and what was put in
  double energy_off =
      0;  ///< largest difference of the program's energies from those that positions
          ///< and velocities give, relative to what there was and was put in
  Compression compression;         ///< recomputed from positions, each figure of its worst frame
  Compression compression_at_end;  ///< of the last frame
  double density_off = 0;  ///< largest difference of the program's densities and compressions from
                           ///< those recomputed, relative to ρ₀
  double max_speed = 0;    ///< m/s
  int steps = 0, rejected = 0;
  std::int64_t iterations = 0;
  sim::FrameStatistics last;  ///< of the last frame
  sim::Frame end;
};

/// Looks at frames one after another. Gravity is in the potential energy; the work of the other
/// body forces is that on the centre of mass. Water that is compressible, as basic SPH's, holds
/// elastic energy besides: Tait's pressure (Monaghan 2005, eq. 4.3) integrated over the
/// compression; so do walls at rest.
class InvariantsWatch {
 public:
  explicit InvariantsWatch(const sim::Settings& settings)
      : settings_(settings),
        densities_(settings),
        mass_(double{settings.fluid.rest_density} * densities_.volume()) {
    if (settings.solver.speed_of_sound == 0)
      settings_.solver.speed_of_sound = sim::default_speed_of_sound(settings);
  }

  void look(const sim::Frame& frame, const sim::FrameStatistics& f) {
    const std::vector<double> ratios = densities_.ratios(frame);
    look_at_particles(frame);
    look_at_densities(ratios, frame, f);
    look_at_energy(ratios, frame, f);
    worst_.max_speed = std::max(worst_.max_speed, f.max_speed);
    worst_.steps += f.steps;
    worst_.rejected += f.rejected_steps;
    worst_.iterations += f.iterations;
    worst_.wall_work += f.wall_work;
    worst_.last = f;
    worst_.end = frame;
  }

  const Invariants& worst() const { return worst_; }

 private:
  void look_at_particles(const sim::Frame& frame) {
    const auto all_finite = [](glm::vec3 v) {
      return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const std::vector<sim::PosedBody> bodies = sim::posed_bodies(settings_, frame.time, frame.time);
    const std::vector<sim::Solid> solids = sim::solids_of(fixed_.obstacles);
    const sim::ContactView contact{
        {settings_.domain.min.x, settings_.domain.min.y, settings_.domain.min.z},
        {settings_.domain.max.x, settings_.domain.max.y, settings_.domain.max.z},
        {solids.data(), static_cast<std::uint32_t>(solids.size()), bodies},
        sim::OpenFaces(settings_.domain)};
    const std::size_t n = frame.positions.size();
    std::vector<bool> seen(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      const glm::vec3 p = frame.positions[i];
      worst_.finite = worst_.finite && all_finite(p) && all_finite(frame.velocities[i]) &&
                      std::isfinite(frame.densities[i]) && std::isfinite(frame.pressures[i]);
      const sim::Vec3<float> in = contact.resolve({p.x, p.y, p.z});
      worst_.outside =
          std::max(worst_.outside, double{glm::distance(p, glm::vec3(in.x, in.y, in.z))});
      const std::uint32_t id = frame.ids[i];
      worst_.count_kept = worst_.count_kept && id < n && !seen[id];
      if (id < n)
        seen[id] = true;
    }
    worst_.count_kept = worst_.count_kept && (count_ == 0 || n == count_);
    count_ = n;
  }

  void look_at_densities(const std::vector<double>& ratios, const sim::Frame& frame,
                         const sim::FrameStatistics& f) {
    Compression now;
    double off = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const double beyond = std::max(0., ratios[i] - 1);
      now.mean += beyond / static_cast<double>(ratios.size());
      now.largest = std::max(now.largest, beyond);
      off = std::max(off, std::abs(frame.densities[i] / settings_.fluid.rest_density - ratios[i]));
    }
    worst_.density_off = std::max({worst_.density_off, off, std::abs(f.mean_compression - now.mean),
                                   std::abs(f.max_compression - now.largest)});
    worst_.compression = {std::max(worst_.compression.mean, now.mean),
                          std::max(worst_.compression.largest, now.largest)};
    worst_.compression_at_end = now;
  }

  void look_at_energy(const std::vector<double>& ratios, const sim::Frame& frame,
                      const sim::FrameStatistics& f) {
    glm::dvec3 center(0);
    for (const glm::vec3 p : frame.positions)
      center += glm::dvec3(p) / static_cast<double>(frame.positions.size());
    const sim::Vec3<float> a = sim::body_acceleration(settings_.forces, frame.time);
    const glm::dvec3 force =
        mass() * (glm::dvec3(a.x, a.y, a.z) - glm::dvec3(settings_.forces.gravity));
    const double mechanical = mechanical_energy(frame);
    const double energy = mechanical + elastic_energy(ratios, frame);
    if (frame.time > 0) {
      const double work = 0.5 * glm::dot(force + last_force_, center - last_center_) + f.wall_work;
      lowest_ += work;
      put_in_ += std::abs(work);
    } else {
      worst_.energy_start = lowest_ = energy;
      put_in_ = std::max(energy, mass() * 1e-6);  // that of 1.4 mm/s, where there is none
    }
    worst_.energy_off = std::max(
        worst_.energy_off, std::abs(f.kinetic_energy + f.potential_energy - mechanical) / put_in_);
    worst_.energy_made = std::max(worst_.energy_made, (energy - lowest_) / put_in_);
    lowest_ = std::min(lowest_, energy);
    last_center_ = center;
    last_force_ = force;
  }

  /// Kinetic and potential, J, the potential against the domain's lowest corner along gravity.
  double mechanical_energy(const sim::Frame& frame) const {
    const glm::dvec3 g(settings_.forces.gravity);
    const glm::dvec3 min(settings_.domain.min), max(settings_.domain.max);
    const glm::dvec3 lowest(g.x > 0 ? max.x : min.x, g.y > 0 ? max.y : min.y,
                            g.z > 0 ? max.z : min.z);
    double sum = 0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
      const glm::dvec3 v(frame.velocities[i]), x(frame.positions[i]);
      sum += 0.5 * glm::dot(v, v) - glm::dot(x - lowest, g);
    }
    return mass_ * sum;
  }

  /// What the pressure accelerations of basic SPH are the gradient of, J: Σ V ∫ p d(ρ/ρ₀) over
  /// particles and boundary particles of walls at rest, from ρ₀ to their densities.
  double elastic_energy(const std::vector<double>& ratios, const sim::Frame& frame) const {
    if (settings_.solver.type != sim::SolverType::sph)
      return 0;
    const double stiffness =
        settings_.fluid.rest_density * std::pow(double{settings_.solver.speed_of_sound}, 2) / 7;
    // Of a volume, 1 m³, in which ρ/ρ₀ is r.
    const auto stored = [&](double r) { return stiffness * ((std::pow(r, 8) - 1) / 8 - (r - 1)); };
    double energy = 0;
    for (const double ratio : ratios)
      energy += densities_.volume() * stored(std::max(1., ratio));
    if (!sim::any_moves(settings_.obstacles))
      for (std::uint32_t b = 0; b < densities_.boundary().count(); ++b)
        energy += double{densities_.boundary().volume(b)} *
                  stored(std::pow(1 + frame.boundary_pressures[b] / stiffness, 1. / 7));
    return energy;
  }

  double mass() const { return mass_ * static_cast<double>(count_); }

  sim::Settings settings_;
  const sim::Settings fixed_ = sim::without_moving(settings_);
  PlainDensities densities_;
  double mass_;  ///< of a particle, kg
  Invariants worst_;
  std::size_t count_ = 0;
  double lowest_ = 0, put_in_ = 0;  // J
  glm::dvec3 last_center_{0}, last_force_{0};
};

/// Runs a simulation for `duration` seconds, looked at `frames` times.
inline Invariants watch(sim::Simulation& simulation, const sim::Settings& settings, double duration,
                        int frames) {
  InvariantsWatch w(settings);
  for (int k = 0; k <= frames; ++k) {
    const sim::FrameStatistics f = simulation.advance_to(duration * k / frames);
    w.look(simulation.frame(), f);
  }
  return w.worst();
}

inline Invariants watch(const sim::Settings& settings, double duration, int frames) {
  sim::Simulation simulation(settings);
  return watch(simulation, settings, duration, frames);
}

/// Appends a line to the file that the environment variable SPINDRIFT_RESULTS names, if it does:
/// tests/physics/results.sh makes docs/results.md of such lines.
inline void record(const std::string& line) {
  if (const char* file = std::getenv("SPINDRIFT_RESULTS"))
    std::ofstream(file, std::ios::app) << line << '\n';
}

}  // namespace spindrift::test
