#include "sim/run/engine.hpp"

#include <optional>
#include <utility>

#include "sim/run/start.hpp"
#include "sim/run/step.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

class Run final : public Engine {
 public:
  Run(const Settings& settings, Stop stop) {
    InitialParticles initial = fill_volumes(settings, stop);
    state_ = std::make_unique<State>(as_filled(settings), initial.positions.size(), stop);
    begin(*state_, initial);
    loose_ = std::move(initial.loose);
    state_->executor.obey(nullptr);
  }

  Run(const Settings& settings, const Frame& frame, Stop stop) {
    const std::size_t initial_count = initial_particle_count(settings);
    state_ = std::make_unique<State>(as_filled(settings), initial_count, stop);
    go_on_from(*state_, frame, initial_count);
    state_->executor.obey(nullptr);
  }

  FrameStatistics advance_to(double end, Stop stop) override {
    FrameStatistics statistics;
    state_->executor.obey(stop);
    try {
      if (loose_)
        come_to_rest(*state_, *std::exchange(loose_, std::nullopt));
      advance(*state_, end, statistics);
    } catch (const Stopped&) {
      // Whoever asked for that knows.
    }
    state_->executor.obey(nullptr);
    return statistics;
  }

  std::future<Frame> take_frame() override {
    State& s = *state_;
    auto copies = copy_particles(s.executor, s.particles, s.constants.rest_density);
    auto wall_pressures = s.walls.pressures(s.executor);
    const auto put_together = [time = s.time, last = s.time_step.last(),
                               allowed = s.time_step.allowed()](auto of_particles, auto of_walls) {
      Frame frame;
      frame.time = time;
      frame.last_time_step = last;
      frame.allowed_time_step = allowed;
      frame.boundary_pressures = of_walls.take();
      of_particles.put_into(frame);
      return frame;
    };
    return std::async(std::launch::deferred, put_together, std::move(copies),
                      std::move(wall_pressures));
  }

  RunFigures figures() const override {
    return {.particles = state_->particles.count,
            .boundary_particles = state_->walls.boundary().count(),
            .memory_bytes = state_->memory_bytes(),
            .phases = state_->executor.clock().entries()};
  }

 private:
  std::unique_ptr<State> state_;
  /// The particles that have yet to come to rest before time begins; none when it has begun.
  std::optional<std::vector<std::uint32_t>> loose_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Settings& settings, Stop stop) {
  return std::make_unique<Run>(settings, stop);
}

std::unique_ptr<Engine> make_engine(const Settings& settings, const Frame& start, Stop stop) {
  return std::make_unique<Run>(settings, start, stop);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
