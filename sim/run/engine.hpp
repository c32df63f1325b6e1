// A run on one backend.
#pragma once

#include <future>
#include <memory>

#include "sim/backend/backend.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::sim {

/// What a Simulation does on the backend that is chosen for it; the members mean the same there.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual FrameStatistics advance_to(double time, Stop stop) = 0;
  virtual std::future<Frame> take_frame() = 0;
  Frame frame() { return take_frame().get(); }
  virtual RunFigures figures() const = 0;
};

inline namespace SPINDRIFT_BACKEND {

/// Makes an engine of the backend that this is compiled for, at the start of a scene, or to go on
/// from a frame. @throws as Simulation's constructors
std::unique_ptr<Engine> make_engine(const Settings& settings, Stop stop = nullptr);
std::unique_ptr<Engine> make_engine(const Settings& settings, const Frame& start,
                                    Stop stop = nullptr);

}  // namespace SPINDRIFT_BACKEND
}  // namespace spindrift::sim
