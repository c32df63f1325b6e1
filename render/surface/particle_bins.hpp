// Sorts particles into the cubic bins of a sparse grid, so that neighbours are found quickly. All
// lengths in this file are in particle spacings unless they are said to be in metres.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/surface/grid_key.hpp"

namespace spindrift::surface {

/// Particles of one neighbourhood, copied together: their coordinates relative to one point.
struct ParticleBatch {
  std::vector<float> x, y, z;

  std::size_t size() const { return x.size(); }
  void clear();
};

/// Particles sorted by their bins. Only occupied bins are kept, ordered by z, then y, then x, and
/// particles are numbered anew in that order.
class ParticleBins {
 public:
  /// @param positions particle centres, m
  /// @param spacing   particle spacing, m
  /// @param bin_size  edge of a bin, in spacings
  /// @param reach     farthest a coordinate may lie from the origin, in spacings; at most 2^20
  /// @throws std::invalid_argument naming the first particle that is not finite or out of reach,
  /// and for more than 2^32 - 1 particles
  ParticleBins(std::span<const glm::vec3> positions, float spacing, double bin_size, double reach);

  std::size_t bin_count() const { return keys_.size(); }
  std::size_t particle_count() const { return x_.size(); }
  double bin_size() const { return bin_size_; }

  /// Grid coordinates of a bin; its lower corner lies at bin_size() times these.
  glm::ivec3 cell(std::size_t bin) const { return grid_cell(keys_[bin]) + lower_; }
  /// The sorted particles of a bin have the numbers begin(bin) ... end(bin) - 1.
  std::uint32_t begin(std::size_t bin) const { return begin_[bin]; }
  std::uint32_t end(std::size_t bin) const { return begin_[bin + 1]; }

  /// Position of a sorted particle relative to the lower corner of its bin.
  glm::vec3 local(std::size_t particle) const { return {x_[particle], y_[particle], z_[particle]}; }

  /// Calls visit(bin) for every occupied bin in the box of cells [lo, hi], both ends included, by
  /// z, then y, then x.
  template <typename Visit>
  void for_each_bin(glm::ivec3 lo, glm::ivec3 hi, Visit visit) const;

  /// Returns what is to be added to positions within a bin to make them relative to `origin`.
  glm::vec3 shift(std::size_t bin, const glm::dvec3& origin) const {
    return glm::vec3(glm::dvec3(cell(bin)) * bin_size_ - origin);
  }

  /// Appends a bin's particles to a batch, with coordinates relative to `origin`.
  void append(std::size_t bin, const glm::dvec3& origin, ParticleBatch& batch) const;

 private:
  double bin_size_;
  glm::ivec3 lower_{0};               ///< smallest coordinates of occupied cells, per axis
  glm::ivec3 upper_{0};               ///< largest coordinates of occupied cells, per axis
  std::vector<std::uint64_t> keys_;   ///< grid_key(cell - lower_) of each bin, ascending
  std::vector<std::uint32_t> begin_;  ///< first particle of each bin, then the particle count
  std::vector<float> x_, y_, z_;      ///< positions of the sorted particles within their bins
};

template <typename Visit>
void ParticleBins::for_each_bin(glm::ivec3 lo, glm::ivec3 hi, Visit visit) const {
  lo = glm::max(lo, lower_) - lower_;
  hi = glm::min(hi, upper_) - lower_;
  if (lo.x > hi.x)
    return;
  for (int z = lo.z; z <= hi.z; ++z) {
    for (int y = lo.y; y <= hi.y; ++y) {
      const std::uint64_t last = grid_key({hi.x, y, z});
      auto it = std::lower_bound(keys_.begin(), keys_.end(), grid_key({lo.x, y, z}));
      for (; it != keys_.end() && *it <= last; ++it)
        visit(std::size_t(it - keys_.begin()));
    }
  }
}

}  // namespace spindrift::surface
