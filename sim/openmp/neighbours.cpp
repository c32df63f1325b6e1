#include "sim/openmp/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace spindrift::sim {
namespace {

constexpr std::size_t cells_per_block = 64;

#ifdef __AVX2__
/// For each 8-bit mask the lanes of its set bits, packed to the front.
constexpr auto packed_lanes = [] {
  std::array<std::array<std::int32_t, lane_count>, 256> table{};
  for (std::size_t mask = 0; mask < 256; ++mask) {
    std::size_t n = 0;
    for (std::int32_t lane = 0; lane < lane_count; ++lane)
      if (mask >> lane & 1)
        table[mask][n++] = lane;
  }
  return table;
}();
#endif

/// Writes first + k for every set bit k of the mask; returns the end of what was written. May write
/// up to eight indices beyond that end.
inline std::uint32_t* append(std::uint32_t* out, std::uint32_t first, unsigned mask) {
#ifdef __AVX2__
  __m256i lanes;
  __builtin_memcpy(&lanes, packed_lanes[mask].data(), sizeof lanes);
  const __m256i indices = _mm256_add_epi32(lanes, _mm256_set1_epi32(static_cast<int>(first)));
  __builtin_memcpy(out, &indices, sizeof indices);
  return out + std::popcount(mask);
#else
  for (; mask != 0; mask &= mask - 1)
    *out++ = first + static_cast<unsigned>(std::countr_zero(mask));
  return out;
#endif
}

inline unsigned closer_than(const Vec3<float>& p, const Vec3Arrays& others, std::uint32_t first,
                            float squared_radius) {
  Lanes x, y, z;
  __builtin_memcpy(&x, others.x + first, sizeof x);
  __builtin_memcpy(&y, others.y + first, sizeof y);
  __builtin_memcpy(&z, others.z + first, sizeof z);
  const Vec3<Lanes> d{p.x - x, p.y - y, p.z - z};
  const IndexLanes near = dot(d, d) < squared_radius;
#ifdef __AVX2__
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(near)));
#else
  unsigned mask = 0;
  for (int k = 0; k < lane_count; ++k)
    mask |= near[k] ? 1u << k : 0u;
  return mask;
#endif
}

/// All points of the runs closer to p than the radius, padded with the sentinel to whole batches.
std::uint32_t* list_of(const Vec3<float>& p, const std::array<RowCursors::Run, 9>& runs,
                       const Vec3Arrays& others, std::uint32_t sentinel, float squared_radius,
                       std::uint32_t* out) {
  std::uint32_t* const begin = out;
  for (const auto& run : runs) {
    for (std::uint32_t j = run.begin; j < run.end; j += lane_count) {
      unsigned mask = closer_than(p, others, j, squared_radius);
      if (run.end - j < lane_count)
        mask &= (1u << (run.end - j)) - 1;
      out = append(out, j, mask);
    }
  }
  while ((out - begin) % lane_count != 0)
    *out++ = sentinel;
  return out;
}

}  // namespace

void NeighbourLists::build(const GridMap& map, const CellGrid& grid, const Vec3Arrays& points,
                           std::uint32_t count, const CellGrid& other_grid,
                           const Vec3Arrays& others, std::uint32_t other_count, float radius) {
  first_.resize(count);
  batches_.resize(count);
  const std::size_t cells = grid.cell_count();
  const std::size_t blocks = (cells + cells_per_block - 1) / cells_per_block;
  if (blocks_.size() < blocks)
    blocks_.resize(blocks);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < blocks; ++b) {
    RowCursors cursors(map, other_grid);
    auto& buffer = blocks_[b];
    std::size_t used = 0;
    const std::size_t first_cell = b * cells_per_block;
    const std::size_t last_cell = std::min(cells, first_cell + cells_per_block);
    for (std::size_t c = first_cell; c < last_cell; ++c) {
      const auto& runs = cursors.around(grid.cell_key(c));
      std::size_t candidates = 0;
      for (const auto& run : runs)
        candidates += run.end - run.begin;
      for (std::uint32_t i = grid.cell_begin(c); i < grid.cell_begin(c + 1); ++i) {
        batches_[i] = 0;
        if (candidates == 0)
          continue;
        if (buffer.size() < used + candidates + 2 * lane_count)
          buffer.resize((used + candidates + 2 * lane_count) * 5 / 4);
        std::uint32_t* const begin = buffer.data() + used;
        const std::uint32_t* const end =
            list_of(points[i], runs, others, other_count, radius * radius, begin);
        batches_[i] = static_cast<std::uint32_t>((end - begin) / lane_count);
        used += static_cast<std::size_t>(end - begin);
      }
    }
    // Only now is the buffer where it stays.
    const std::uint32_t* at = buffer.data();
    for (std::uint32_t i = grid.cell_begin(first_cell); i < grid.cell_begin(last_cell); ++i) {
      first_[i] = at;
      at += batches_[i] * lane_count;
    }
  }
}

std::size_t NeighbourLists::memory_bytes() const {
  std::size_t bytes = first_.capacity() * sizeof(void*) + batches_.capacity() * 4;
  for (const auto& block : blocks_)
    bytes += block.capacity() * 4;
  return bytes;
}

}  // namespace spindrift::sim
