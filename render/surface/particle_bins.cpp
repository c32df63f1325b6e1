#include "render/surface/particle_bins.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace spindrift::surface {
namespace {

[[noreturn]] void reject(std::size_t index, const glm::vec3& p, double reach_metres) {
  const std::string at = fmt::format("particle {} at ({}, {}, {}) m", index, p.x, p.y, p.z);
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    throw std::invalid_argument(at + " has no finite position");
  throw std::invalid_argument(
      fmt::format("{} is too far away: coordinates must lie within ±{:.3g} m", at, reach_metres));
}

}  // namespace

void ParticleBatch::clear() {
  x.clear();
  y.clear();
  z.clear();
}

ParticleBins::ParticleBins(std::span<const glm::vec3> positions, float spacing, double bin_size,
                           double reach)
    : bin_size_(bin_size) {
  const std::size_t n = positions.size();
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument(fmt::format("{} particles are more than 2^32 - 1", n));
  const double bins_per_metre = 1.0 / (double(spacing) * bin_size);
  const double farthest = reach * double(spacing);
  const auto bin_position = [&](std::size_t i) {
    return glm::dvec3(positions[i]) * bins_per_metre;
  };

  std::vector<glm::ivec3> cells(n);
  std::size_t bad = n;
#pragma omp parallel for schedule(static) reduction(min : bad)
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 p = glm::abs(glm::dvec3(positions[i]));
    if (p.x <= farthest && p.y <= farthest && p.z <= farthest)
      cells[i] = glm::ivec3(glm::floor(bin_position(i)));
    else
      bad = std::min(bad, i);
  }
  if (bad < n)
    reject(bad, positions[bad], farthest);
  if (n == 0) {
    begin_.push_back(0);
    return;
  }

  lower_ = upper_ = cells[0];
  for (const glm::ivec3& c : cells) {
    lower_ = glm::min(lower_, c);
    upper_ = glm::max(upper_, c);
  }
  std::vector<KeyedIndex> order(n);
  for (std::size_t i = 0; i < n; ++i)
    order[i] = {grid_key(cells[i] - lower_), std::uint32_t(i)};
  sort_by_key(order);

  x_.resize(n);
  y_.resize(n);
  z_.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = order[k].index;
    const glm::vec3 local((bin_position(i) - glm::dvec3(cells[i])) * bin_size);
    x_[k] = local.x;
    y_[k] = local.y;
    z_[k] = local.z;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (k == 0 || order[k].key != order[k - 1].key) {
      keys_.push_back(order[k].key);
      begin_.push_back(std::uint32_t(k));
    }
  }
  begin_.push_back(std::uint32_t(n));
}

void ParticleBins::append(std::size_t bin, const glm::dvec3& origin, ParticleBatch& batch) const {
  const glm::vec3 by = shift(bin, origin);
  const auto shifted = [this, bin](const std::vector<float>& from, float offset,
                                   std::vector<float>& to) {
    const std::size_t first = to.size();
    to.resize(first + (end(bin) - begin(bin)));
    for (std::size_t k = begin(bin), j = first; k < end(bin); ++k, ++j)
      to[j] = from[k] + offset;
  };
  shifted(x_, by.x, batch.x);
  shifted(y_, by.y, batch.y);
  shifted(z_, by.z, batch.z);
}

}  // namespace spindrift::surface
