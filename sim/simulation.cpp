#include "sim/simulation.hpp"

#include <stdexcept>

#include "sim/engine.hpp"
#ifdef SPINDRIFT_CUDA
#include "sim/device/device_engine.hpp"
#endif

namespace spindrift::sim {
namespace {

/// @throws std::invalid_argument when CUDA is asked for and cannot run the settings
template <class... Start>
std::unique_ptr<Engine> engine_for(const BackendChoice& choice, const Settings& settings,
                                   const Start&... start) {
  if (choice.backend == Backend::cuda) {
    const std::string why_not = why_not_cuda(settings);
    if (!why_not.empty())
      throw std::invalid_argument("solver.backend is \"cuda\", but " + why_not +
                                  "; ask for \"cpu\" or \"auto\"");
#ifdef SPINDRIFT_CUDA
    return make_device_engine(settings, start...);
#endif
  }
  return make_engine(settings, start...);
}

}  // namespace

Simulation::Simulation(const Settings& settings)
    : backend_(choose_backend(settings)), engine_(engine_for(backend_, settings)) {}

Simulation::Simulation(const Settings& settings, const Frame& start)
    : backend_(choose_backend(settings)), engine_(engine_for(backend_, settings, start)) {}

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
