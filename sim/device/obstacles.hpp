// Obstacles as loops on the device see them: those that a formula describes, and that stand still.
#pragma once

#include <cstdint>
#include <span>

#include "sim/posed_body.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim::inline device {

struct ObstacleView {
  const Solid* solids = nullptr;
  std::uint32_t count = 0;

  ObstacleView() = default;
  ObstacleView(const Solid* fixed, std::uint32_t fixed_count, std::span<const PosedBody> = {})
      : solids(fixed), count(fixed_count) {}

  /// The point itself, or one outside every obstacle, near it.
  SPINDRIFT_HD Vec3<float> hold(Vec3<float> p) const {
    for (std::uint32_t k = 0; k < count; ++k)
      p = push_out_of_formula(solids[k], p);
    return p;
  }

  SPINDRIFT_HD Vec3<float> sweep(const Vec3<float>&, const Vec3<float>& p) const { return p; }
  SPINDRIFT_HD bool any_moves() const { return false; }
  SPINDRIFT_HD Vec3<float> velocity_behind(const Vec3<float>&, const Vec3<float>&) const {
    return {0, 0, 0};
  }
};

}  // namespace spindrift::sim::inline device
