#include "sim/openmp/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>

namespace spindrift::sim::inline openmp {
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

/// All points of the runs closer to p than the radius, padded with the sentinel to whole batches,
/// after their number.
std::uint32_t* list_of(const Vec3<float>& p, const std::array<RowCursors::Run, 9>& runs,
                       const Vec3Arrays& others, std::uint32_t sentinel, float squared_radius,
                       std::uint32_t* const list) {
  std::uint32_t* const begin = list + 1;
  std::uint32_t* out = begin;
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
  *list = static_cast<std::uint32_t>((out - begin) / lane_count);
  return out;
}

constexpr std::uint32_t empty_list = 0;

}  // namespace

/// One thread's place in the chunks. Lists lie one after the other; how long they will be need not
/// be known, only how long they can be, so that nothing is copied and hardly anything left unused.
class NeighbourLists::Writer {
 public:
  explicit Writer(NeighbourLists& lists) : lists_(lists) {}

  /// Room for a list of up to `most` numbers.
  std::uint32_t* room(std::size_t most) {
    if (static_cast<std::size_t>(end_ - at_) < most)
      take(most);
    return at_;
  }
  /// Keeps the list that was written there, up to `end`; returns its place.
  std::uint32_t keep(std::uint32_t* end) {
    if (*at_ == 0)
      return 0;
    const std::uint32_t place = place_;
    place_ += static_cast<std::uint32_t>(end - at_);
    at_ = end;
    return place;
  }

 private:
  void take(std::size_t most) {
    constexpr std::size_t size = NeighbourView::chunk_size;
    const std::size_t count = (most + size - 1) / size;
#pragma omp critical(spindrift_neighbour_chunks)
    {
      if (count > 1) {
        at_ = lists_.large_.emplace_back(count * size).data();
      } else {
        if (lists_.taken_ == lists_.chunks_.size())
          lists_.chunks_.push_back(std::make_unique_for_overwrite<std::uint32_t[]>(size));
        at_ = lists_.chunks_[lists_.taken_++].get();
      }
      place_ = static_cast<std::uint32_t>(lists_.table_.size() * size);
      for (std::size_t k = 0; k < count; ++k)
        lists_.table_.push_back(at_ + k * size);
    }
    end_ = at_ + count * size;
  }

  NeighbourLists& lists_;
  std::uint32_t *at_ = nullptr, *end_ = nullptr;
  std::uint32_t place_ = 0;
};

void NeighbourLists::build(const GridMap& map, const CellGrid& grid, const Vec3Arrays& points,
                           std::uint32_t count, const CellGrid& other_grid,
                           const Vec3Arrays& others, std::uint32_t other_count, float radius) {
  place_.resize(count);
  table_.assign(1, &empty_list);
  large_.clear();
  taken_ = 0;
  const std::size_t cells = grid.cell_count();
  const std::size_t blocks = (cells + cells_per_block - 1) / cells_per_block;
#pragma omp parallel
  {
    Writer writer(*this);
#pragma omp for schedule(dynamic, 1)
    for (std::size_t b = 0; b < blocks; ++b) {
      RowCursors cursors(map, other_grid.view());
      const std::size_t last_cell = std::min(cells, (b + 1) * cells_per_block);
      for (auto c = static_cast<std::uint32_t>(b * cells_per_block); c < last_cell; ++c) {
        const auto& runs = cursors.around(grid.cell_key(c));
        std::size_t candidates = 0;
        for (const auto& run : runs)
          candidates += run.end - run.begin;
        for (std::uint32_t i = grid.cell_begin(c); i < grid.cell_begin(c + 1); ++i) {
          if (candidates == 0) {
            place_[i] = 0;
            continue;
          }
          std::uint32_t* const room = writer.room(candidates + 2 * lane_count + 1);
          place_[i] =
              writer.keep(list_of(points[i], runs, others, other_count, radius * radius, room));
        }
      }
    }
  }
  if (table_.size() > std::size_t{1} << (32 - NeighbourView::chunk_bits))
    throw std::length_error("more than four billion neighbours; use a larger fluid.spacing");
}

std::size_t NeighbourLists::memory_bytes() const {
  std::size_t numbers = place_.capacity() + chunks_.size() * NeighbourView::chunk_size;
  for (const auto& list : large_)
    numbers += list.capacity();
  return numbers * sizeof(std::uint32_t) + (table_.capacity() + chunks_.capacity()) * sizeof(void*);
}

}  // namespace spindrift::sim::inline openmp
