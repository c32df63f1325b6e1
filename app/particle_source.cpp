#include "app/particle_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "app/interrupt.hpp"

namespace spindrift::app {

ParticleSource::ParticleSource(const Scene& scene, const RenderOptions& options) : scene_(scene) {
  if (options.from_particles) {
    read_only_ = true;
    cache_.emplace(*options.from_particles);
    particle_count_ = cache_->read(0).frame.positions.size();
    return;
  }
  if (options.cache)
    cache_.emplace(options.output / "particles" / simulation_hash(scene));
  particle_count_ = sim::fill_volumes(scene.simulation).positions.size();
}

ParticleSource::~ParticleSource() = default;

std::optional<KeptFrame> ParticleSource::next(int number) {
  if (InterruptGuard::requested())
    return std::nullopt;
  if (read_only_)
    return cache_->read(number);
  cached_so_far_ = cached_so_far_ && cache_ && cache_->has(number);
  if (cached_so_far_) {
    last_ = cache_->read(number);
    return last_;
  }
  KeptFrame kept = simulate(number);
  if (InterruptGuard::requested())
    return std::nullopt;
  ++simulated_;
  if (cache_)
    cache_->write(number, kept);
  return kept;
}

KeptFrame ParticleSource::simulate(int number) {
  if (!simulation_) {
    if (number == 0)
      simulation_ = std::make_unique<sim::Simulation>(scene_.simulation);
    else
      simulation_ = std::make_unique<sim::Simulation>(scene_.simulation, last_.frame);
  }
  const double time = static_cast<double>(number) / scene_.video.frames_per_second;
  KeptFrame kept;
  kept.statistics = simulation_->advance_to(time, &InterruptGuard::requested());
  if (!InterruptGuard::requested())
    kept.frame = simulation_->frame();
  return kept;
}

void ParticleSource::finish(RunRecord& record) const {
  record.particles = particle_count_;
  record.frames_simulated = simulated_;
  if (!simulation_)
    return;
  record.boundary_particles = simulation_->boundary_particle_count();
  record.simulation_bytes = simulation_->memory_bytes();
  record.simulation_phases = simulation_->phase_times();
}

}  // namespace spindrift::app
