#include "sim/start/packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/backend/point_cells.hpp"
#include "sim/core/kernels.hpp"

namespace spindrift::sim {
namespace {

constexpr int packing_sweeps = 20;
constexpr float packing_rate = 0.5f;  ///< displacement in a sweep, spacings d, per d⁴ Σ ∇W
constexpr float longest_packing_way = 0.1f;  ///< longest displacement in a sweep, spacings d

}  // namespace

void pack(std::vector<glm::vec3>& positions, const std::vector<PackedParticle>& moves,
          const std::vector<glm::vec3>& walls, const StandingBodies& bodies, float spacing,
          Stop stop) {
  const float radius = 2 * spacing;
  const CubicKernel kernel(radius);
  // One grid of cells, a spacing wider than the support radius, serves all sweeps.
  const PointCells cells(positions, radius + spacing), wall_cells(walls, radius + spacing);
  const auto count = static_cast<std::int64_t>(moves.size());
  std::vector<glm::vec3> next(moves.size());
  for (int sweep = 0; sweep < packing_sweeps; ++sweep) {
    throw_if_stopped(stop);
#pragma omp parallel for schedule(dynamic, 256)
    for (std::int64_t m = 0; m < count; ++m) {
      const auto [number, axes] = moves[static_cast<std::size_t>(m)];
      const glm::vec3 p = positions[number];
      glm::vec3 sum(0);
      const auto add = [&](const glm::vec3& other) {
        const glm::vec3 d = p - other;
        if (glm::dot(d, d) < radius * radius)
          sum += kernel.gradient(glm::length(d)) * d;
      };
      cells.for_near(p, [&, number = number](std::uint32_t j) {
        if (j != number)
          add(positions[j]);
      });
      wall_cells.for_near(p, [&](std::uint32_t j) { add(walls[j]); });
      glm::vec3 way = -packing_rate * std::pow(spacing, 4.f) * axes * sum;  // in spacings
      way *= std::min(1.f, longest_packing_way / std::max(glm::length(way), 1e-9f));
      next[static_cast<std::size_t>(m)] = bodies.push_out(p + spacing * way);
    }
    for (std::size_t m = 0; m < moves.size(); ++m)
      positions[moves[m].number] = next[m];
  }
}

}  // namespace spindrift::sim
