#include "sim/boundary/walls.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "sim/boundary/obstacle_motion.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

Walls::Walls(const Settings& settings, const GridMap& map, float radius, Stop stop)
    : fixed_(without_moving(settings)),
      boundary_(fixed_, map, radius, stop),
      moving_(sim::any_moves(settings.obstacles)
                  ? std::make_unique<MovingBodies>(settings, map, boundary_, meshes_, stop)
                  : nullptr) {
  put(solids_, solids_of(fixed_.obstacles, meshes_));
}

ContactView Walls::contact() const {
  const std::span<const PosedBody> bodies =
      moving_ ? std::span(moving_->bodies().data(), moving_->bodies().size()) : decltype(bodies){};
  return {from_glm(fixed_.domain.min), from_glm(fixed_.domain.max),
          ObstacleView{solids_.data(), static_cast<std::uint32_t>(solids_.size()), bodies,
                       fixed_.fluid.spacing},
          OpenFaces(fixed_.domain)};
}

void Walls::move(Executor& executor, double start, double end) {
  if (moving_)
    moving_->place(executor, start, end);
}

double Walls::step_within(double distance, double time, double longest) const {
  return moving_ ? moving_->step_within(distance, time, longest) : longest;
}

Copy<float> Walls::pressures(Executor& executor) {
  if (moving_)
    return moving_->pressures(executor);
  const float* pressure = boundary_.pressures().data();
  return executor.copy<float>("take frame", boundary_.count(),
                              [=] SPINDRIFT_HD(std::uint32_t b) { return pressure[b]; });
}

void Walls::set_pressures(const std::vector<float>& pressures) {
  const std::size_t samples = moving_ ? moving_->sample_count() : boundary_.count();
  if (pressures.size() != samples)
    throw std::invalid_argument("cannot go on from a frame with other walls or obstacles");
  if (moving_)
    moving_->set_pressures(pressures);
  else
    std::copy(pressures.begin(), pressures.end(), boundary_.pressures().data());
}

std::size_t Walls::memory_bytes() const {
  return bytes_of(boundary_, meshes_, solids_) + (moving_ ? bytes_of(*moving_) : 0);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
