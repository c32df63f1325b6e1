#include "app/run/particle_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "app/checks/estimate.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/system/interrupt.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

/// Adds the statistics of a later part of the time between two frames.
void append(sim::FrameStatistics& whole, const sim::FrameStatistics& part) {
  sim::FrameStatistics sum = part;  // measured figures are those of the end
  sum.steps += whole.steps;
  sum.rejected_steps += whole.rejected_steps;
  sum.iterations += whole.iterations;
  sum.contacts += whole.contacts;
  sum.wall_work += whole.wall_work;
  sum.exchange += whole.exchange;
  sum.max_time_step = std::max(whole.max_time_step, part.max_time_step);
  if (whole.steps > 0 && (part.steps == 0 || whole.min_time_step < part.min_time_step))
    sum.min_time_step = whole.min_time_step;
  whole = sum;
}

std::future<sim::Frame> ready(sim::Frame frame) {
  std::promise<sim::Frame> promise;
  promise.set_value(std::move(frame));
  return promise.get_future();
}

}  // namespace

ParticleSource::ParticleSource(const Scene& scene, const RenderOptions& options,
                               std::vector<ProbeReading>& readings)
    : scene_(scene), readings_(readings) {
  if (!scene.probes.empty() && scene.probes_rate > 0)
    readings_name_ = text_hash(json_of(scene.probes).dump()).substr(0, 16) + ".readings";
  earlier_.scene_name = scene.name;
  earlier_.scene_file = options.scene_file;
  if (options.from_particles) {
    read_only_ = true;
    cache_.emplace(*options.from_particles);
    particle_count_ = cache_->read(0).frame.positions.size();
    earlier_ = cache_->read_record().value_or(earlier_);
    return;
  }
  if (options.cache)
    cache_.emplace(options.output / "particles" / simulation_hash(scene), simulation_hash(scene));
  particle_count_ = count_particles(scene.simulation);
}

ParticleSource::~ParticleSource() = default;

std::optional<ComingFrame> ParticleSource::next(int number) {
  if (InterruptGuard::requested())
    return std::nullopt;
  if (read_only_)
    return cached(number, cache_->read(number));
  if (std::optional<CachedFrame> found = cache_ ? cache_->find(number) : std::nullopt) {
    if (number == 0)
      earlier_.take_over(cache_->read_record());
    if (simulation_)  // it filled a gap between cached frames; a later gap needs a new one
      earlier_ = record();
    simulation_.reset();
    last_ = found->frame;
    return cached(number, std::move(*found));
  }
  const std::size_t readings_before = readings_.size();
  const auto begin = std::chrono::steady_clock::now();
  std::optional<ComingFrame> coming = simulate(number);
  if (!coming)
    return std::nullopt;
  earlier_.seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  particle_count_ = std::max(particle_count_, coming->particle_count);
  ++simulated_;
  if (cache_) {
    keep_readings(number, readings_before);
    cache_->write_record(record());
  }
  return coming;
}

CachedFrame ParticleSource::keep(int number, ComingFrame coming) const {
  CachedFrame frame{coming.frame.get(), coming.statistics};
  if (cache_ && !coming.cached)
    cache_->write(number, frame);
  return frame;
}

/// Makes the simulation that computes frame `number`, from the frame before.
/// @return whether it was made: false after Ctrl-C
bool ParticleSource::start_simulation(int number) {
  const sim::Stop stop = &InterruptGuard::requested();
  try {
    simulation_ = number == 0 ? std::make_unique<sim::Simulation>(scene_.simulation, stop)
                              : std::make_unique<sim::Simulation>(scene_.simulation, last_, stop);
  } catch (const sim::Stopped&) {
    return false;
  }
  if (number > 0 && !readings_due(number).empty())
    at_last_stop_ = app::read_probes(scene_, last_);
  last_ = {};
  return true;
}

/// Advances the simulation to a frame, and reads the probes on the way.
/// @return nothing after Ctrl-C
std::optional<ComingFrame> ParticleSource::simulate(int number) {
  if (!simulation_ && !start_simulation(number))
    return std::nullopt;
  const double time = time_of(number), begin = number == 0 ? 0 : time_of(number - 1);
  const std::vector<double> readings = readings_due(number);
  ComingFrame coming;
  auto due = readings.cbegin();
  for (const double at : stop_times(begin, time, number == 0 ? 1 : readings.size())) {
    append(coming.statistics, simulation_->advance_to(at, &InterruptGuard::requested()));
    if (InterruptGuard::requested())
      return std::nullopt;
    if (at < time)
      due = read_probes(simulation_->frame(), due, readings.cend());
  }
  coming.frame = simulation_->take_frame();
  coming.time = time;
  coming.particle_count = simulation_->figures().particles;
  if (!readings.empty() || !readings_due(number + 1).empty()) {
    sim::Frame frame = coming.frame.get();
    read_probes(frame, due, readings.cend());
    coming.frame = ready(std::move(frame));
  }
  return coming;
}

/// Reads the probes at a stop, and adds the readings that have become due since the last stop.
/// @param due the first reading not yet added
/// @return the first reading that is due later
std::vector<double>::const_iterator ParticleSource::read_probes(
    const sim::Frame& frame, std::vector<double>::const_iterator due,
    std::vector<double>::const_iterator end) {
  ProbeReading now = app::read_probes(scene_, frame);
  const double rounding = 1e-9 * now.time;
  for (; due != end && *due <= now.time + rounding; ++due)
    readings_.push_back(reading_between(at_last_stop_, now, *due));
  at_last_stop_ = std::move(now);
  return due;
}

ComingFrame ParticleSource::cached(int number, CachedFrame frame) {
  const double time = frame.frame.time;
  const std::size_t particles = frame.frame.positions.size();
  particle_count_ = std::max(particle_count_, particles);
  if (!add_cached_readings(number)) {
    if (!scene_.probes.empty())
      readings_.push_back(app::read_probes(scene_, frame.frame));
    ++read_once_;
  }
  return {ready(std::move(frame.frame)), frame.statistics, time, particles, true};
}

/// Writes the readings since the frame before, from index `first` on, to the cache. This happens
/// before the frame itself is written, so that a cached frame always has its readings. Numbers are
/// written as they stand in memory, like the frame's.
void ParticleSource::keep_readings(int number, std::size_t first) const {
  if (readings_name_.empty())
    return;
  std::vector<double> values;
  for (std::size_t i = first; i < readings_.size(); ++i) {
    values.push_back(readings_[i].time);
    values.insert(values.end(), readings_[i].values.begin(), readings_[i].values.end());
  }
  cache_->write_readings(number, readings_name_, values);
}

/// Adds the readings that were written to the cache with a frame.
/// @return whether they were there
bool ParticleSource::add_cached_readings(int number) {
  if (readings_name_.empty())
    return false;
  const std::optional<std::vector<double>> values = cache_->read_readings(number, readings_name_);
  std::size_t columns = 1;  // the time
  for (const sim::Probe& probe : scene_.probes)
    columns += sim::probe_columns(probe).size();
  if (!values || values->size() % columns != 0)
    return false;
  for (auto at = values->begin(); at != values->end(); at += static_cast<long>(columns))
    readings_.push_back({*at, {at + 1, at + static_cast<long>(columns)}});
  return true;
}

/// The times, s, of the readings after the frame before and up to frame `number`.
std::vector<double> ParticleSource::readings_due(int number) const {
  if (scene_.probes.empty())
    return {};
  if (scene_.probes_rate == 0)
    return {time_of(number)};
  return reading_times(number == 0 ? -1 : time_of(number - 1), time_of(number), scene_.probes_rate);
}

double ParticleSource::time_of(int number) const {
  return scene_.video.frames_per_second.time_of(number);
}

SimulationRecord ParticleSource::record() const {
  SimulationRecord sum = earlier_;
  if (!simulation_)
    return sum;
  sum.backend = simulation_->backend();
  const sim::RunFigures figures = simulation_->figures();
  sum.boundary_particles = figures.boundary_particles;
  sum.bytes = std::max(sum.bytes, figures.memory_bytes);
  sum.add_phases(figures.phases);
  return sum;
}

void ParticleSource::finish(RunRecord& record) const {
  record.particles = particle_count_;
  record.frames_simulated = simulated_;
  record.frames_read_once = readings_name_.empty() ? 0 : read_once_;
  record.simulation = this->record();
}

}  // namespace spindrift::app
