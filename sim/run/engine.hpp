// A run on one backend.
#pragma once

#include <future>
#include <memory>

#include "sim/backend/backend.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::sim {

/// As Simulation, which has one.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual FrameStatistics advance_to(double time, Stop stop) = 0;
  virtual std::future<Frame> take_frame() = 0;
  Frame frame() { return take_frame().get(); }
  virtual std::size_t particle_count() const = 0;
  virtual std::size_t boundary_particle_count() const = 0;
  virtual std::size_t memory_bytes() const = 0;
  virtual const PhaseClock& clock() const = 0;
};

inline namespace SPINDRIFT_BACKEND {

/// @throws Stopped
std::unique_ptr<Engine> make_engine(const Settings& settings, Stop stop = nullptr);
std::unique_ptr<Engine> make_engine(const Settings& settings, const Frame& start,
                                    Stop stop = nullptr);

}  // namespace SPINDRIFT_BACKEND
}  // namespace spindrift::sim
