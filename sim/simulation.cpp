#include "sim/simulation.hpp"

#include "sim/engine.hpp"

namespace spindrift::sim {

Simulation::Simulation(const Settings& settings) : engine_(make_engine(settings)) {}

Simulation::Simulation(const Settings& settings, const Frame& start)
    : engine_(make_engine(settings, start)) {}

Simulation::~Simulation() = default;

FrameStatistics Simulation::advance_to(double time, const std::atomic<bool>* stop) {
  return engine_->advance_to(time, stop);
}

Frame Simulation::frame() const {
  return engine_->frame();
}

std::size_t Simulation::particle_count() const {
  return engine_->particle_count();
}
std::size_t Simulation::boundary_particle_count() const {
  return engine_->boundary_particle_count();
}
std::size_t Simulation::memory_bytes() const {
  return engine_->memory_bytes();
}

std::vector<PhaseTime> Simulation::phase_times() const {
  std::vector<PhaseTime> times;
  for (const auto& e : engine_->clock().entries())
    times.push_back({std::string(e.name), e.seconds, e.calls});
  return times;
}

}  // namespace spindrift::sim
