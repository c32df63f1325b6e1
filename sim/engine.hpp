// A run on one backend.
#pragma once

#include <atomic>
#include <future>
#include <memory>

#include "sim/backend.hpp"
#include "sim/simulation.hpp"

namespace spindrift::sim {

/// As Simulation, which has one.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual FrameStatistics advance_to(double time, const std::atomic<bool>* stop) = 0;
  virtual std::future<Frame> take_frame() = 0;
  Frame frame() { return take_frame().get(); }
  virtual std::size_t particle_count() const = 0;
  virtual std::size_t boundary_particle_count() const = 0;
  virtual std::size_t memory_bytes() const = 0;
  virtual const PhaseClock& clock() const = 0;
};

inline namespace SPINDRIFT_BACKEND {

std::unique_ptr<Engine> make_engine(const Settings& settings);
std::unique_ptr<Engine> make_engine(const Settings& settings, const Frame& start);

}  // namespace SPINDRIFT_BACKEND
}  // namespace spindrift::sim
