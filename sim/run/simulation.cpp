#include "sim/run/simulation.hpp"

#include <stdexcept>

#include "sim/run/engine.hpp"
#ifdef SPINDRIFT_CUDA
#include "sim/run/device_engine.hpp"
#endif

namespace spindrift::sim {
namespace {

template <class... Start>
std::unique_ptr<Engine> engine_for([[maybe_unused]] const BackendChoice& choice,
                                   const Settings& settings, const Start&... start) {
  const std::string refused = why_refused(settings);
  if (!refused.empty())
    throw std::invalid_argument(refused);
#ifdef SPINDRIFT_CUDA
  if (choice.backend == Backend::cuda)
    return make_device_engine(settings, start...);
#endif
  return make_engine(settings, start...);
}

}  // namespace

Simulation::Simulation(const Settings& settings, Stop stop)
    : backend_(choose_backend(settings)), engine_(engine_for(backend_, settings, stop)) {}

Simulation::Simulation(const Settings& settings, const Frame& start, Stop stop)
    : backend_(choose_backend(settings)), engine_(engine_for(backend_, settings, start, stop)) {}

Simulation::~Simulation() = default;

FrameStatistics Simulation::advance_to(double time, Stop stop) {
  return engine_->advance_to(time, stop);
}

std::future<Frame> Simulation::take_frame() {
  return engine_->take_frame();
}

RunFigures Simulation::figures() const {
  return engine_->figures();
}

}  // namespace spindrift::sim
