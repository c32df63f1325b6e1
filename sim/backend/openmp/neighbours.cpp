#include "sim/backend/openmp/neighbours.hpp"

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

/// Writes the lanes of the mask's set bits, packed to the front, and returns how many there are. It
/// may write all eight lanes.
template <class Numbers>
inline std::uint32_t write_chosen(void* out, Numbers lanes, unsigned mask) {
#ifdef __AVX2__
  __m256i order;
  __builtin_memcpy(&order, packed_lanes[mask].data(), sizeof order);
  const __m256i chosen = _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(lanes), order);
  __builtin_memcpy(out, &chosen, sizeof chosen);
#else
  auto* place = static_cast<char*>(out);
  for (unsigned left = mask; left != 0; left &= left - 1, place += sizeof lanes[0]) {
    const auto number = lanes[std::countr_zero(left)];
    __builtin_memcpy(place, &number, sizeof number);
  }
#endif
  return static_cast<std::uint32_t>(std::popcount(mask));
}

/// A mask with a bit for each lane, set where the lane is not zero.
inline unsigned bits_of(IndexLanes chosen) {
#ifdef __AVX2__
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(chosen)));
#else
  unsigned mask = 0;
  for (int k = 0; k < lane_count; ++k)
    mask |= chosen[k] ? 1u << k : 0u;
  return mask;
#endif
}

/// The smallest box around the points of a cell.
struct Bounds {
  Vec3<float> min, max;

  Bounds(const PointView& points, std::uint32_t begin, std::uint32_t end)
      : min(points[begin]), max(min) {
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      const Vec3<float> p = points[i];
      min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
  }

  Lanes squared_distance(const LaneRows& p) const {
    const Vec3<Lanes> d{outside(p.x, min.x, max.x), outside(p.y, min.y, max.y),
                        outside(p.z, min.z, max.z)};
    return dot(d, d);
  }

 private:
  static Lanes outside(Lanes x, float low, float high) {
    const Lanes below = low - x, above = x - high, out = below > above ? below : above;
    return out > 0.f ? out : 0.f * x;
  }
};

/// The points that may be near those of one cell, side by side in memory. They are loaded once for
/// all of the cell's points, which are about nine. Points too far from all of them are left out.
class Candidates {
 public:
  void find(const Bounds& bounds, const std::array<RowCursors::Run, 9>& runs,
            const PointView& others, float squared_radius) {
    constexpr IndexLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
    std::size_t most = 2 * lane_count;
    for (const auto& run : runs)
      most += run.end - run.begin;
    if (most > place_.size())
      for (auto* values : {&x_, &y_, &z_})
        values->resize(2 * most);
    place_.resize(x_.size());
    count_ = 0;
    for (const auto& run : runs)
      for (std::uint32_t j = run.begin; j < run.end; j += lane_count) {
        const LaneRows p = load(others.rows, LaneRun{j});
        const auto first = static_cast<std::int32_t>(LaneList::place_of(j));
        // The radius is a little larger here since the distance to the box is rounded.
        const unsigned mask = bits_of((bounds.squared_distance(p) < 1.00001f * squared_radius) &
                                      (lane < static_cast<std::int32_t>(run.end - j)));
        write_chosen(&x_[count_], p.x, mask);
        write_chosen(&y_[count_], p.y, mask);
        write_chosen(&z_[count_], p.z, mask);
        count_ += write_chosen(&place_[count_], (lane << LaneList::row_bits) + first, mask);
      }
    for (std::uint32_t k = count_; k < count_ + lane_count; ++k)
      x_[k] = sentinel_position;
  }

  std::uint32_t count() const { return count_; }

  /// Writes the list of all candidates closer to p than the radius: the number of its batches, then
  /// the candidates' places, padded with that of the sentinel to whole batches. Returns the list's
  /// end.
  std::uint32_t* list(const Vec3<float>& p, float squared_radius, std::uint32_t sentinel,
                      std::uint32_t* const list) const {
    std::uint32_t* const begin = list + 1;
    std::uint32_t* out = begin;
    for (std::uint32_t k = 0; k < count_; k += lane_count) {
      const Vec3<Lanes> d{p.x - consecutive(&x_[k]), p.y - consecutive(&y_[k]),
                          p.z - consecutive(&z_[k])};
      IndexLanes place;
      __builtin_memcpy(&place, &place_[k], sizeof place);
      out += write_chosen(out, place, bits_of(dot(d, d) < squared_radius));
    }
    while ((out - begin) % lane_count != 0)
      *out++ = LaneList::place_of(sentinel);
    *list = static_cast<std::uint32_t>((out - begin) / lane_count);
    return out;
  }

 private:
  std::vector<float> x_, y_, z_;
  std::vector<std::uint32_t> place_;
  std::uint32_t count_ = 0;
};

constexpr std::uint32_t empty_list = 0;

}  // namespace

/// Where one thread writes its lists in the chunks, one after the other. Only the length that a
/// list can have must be known before, not the one that it will have, so that nothing is copied and
/// hardly any memory is left unused.
class NeighbourLists::Writer {
 public:
  explicit Writer(NeighbourLists& lists) : lists_(lists) {}

  /// Memory for a list of up to `most` numbers.
  std::uint32_t* room(std::size_t most) {
    if (static_cast<std::size_t>(end_ - at_) < most)
      take(most);
    return at_;
  }
  /// Keeps the list that was written there, up to `end`, and returns its place in the chunks; an
  /// empty list has place 0.
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

void NeighbourLists::build(const GridMap& map, const CellGrid& grid, const PointView& points,
                           std::uint32_t count, const CellGrid& other_grid, const PointView& others,
                           std::uint32_t other_count, float radius) {
  if (other_count >= LaneList::number_at(~0u))
    throw std::length_error("more than 268 million particles; use a larger fluid.spacing");
  place_.resize(count);
  table_.assign(1, &empty_list);
  large_.clear();
  taken_ = 0;
  const std::size_t cells = grid.cell_count();
  const std::size_t blocks = (cells + cells_per_block - 1) / cells_per_block;
#pragma omp parallel
  {
    Writer writer(*this);
    Candidates candidates;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t b = 0; b < blocks; ++b) {
      RowCursors cursors(map, other_grid.view());
      const std::size_t last_cell = std::min(cells, (b + 1) * cells_per_block);
      for (auto c = static_cast<std::uint32_t>(b * cells_per_block); c < last_cell; ++c) {
        const std::uint32_t begin = grid.cell_begin(c), end = grid.cell_begin(c + 1);
        const auto& runs = cursors.around(grid.cell_key(c));
        // So it is around most boundary particles of dry walls.
        if (std::all_of(runs.begin(), runs.end(), [](auto& run) { return run.begin == run.end; })) {
          std::fill(&place_[begin], &place_[begin] + (end - begin), 0u);
          continue;
        }
        candidates.find(Bounds(points, begin, end), runs, others, radius * radius);
        for (std::uint32_t i = begin; i < end; ++i) {
          std::uint32_t* const room = writer.room(candidates.count() + 2 * lane_count + 1);
          place_[i] = writer.keep(candidates.list(points[i], radius * radius, other_count, room));
        }
      }
    }
  }
  if (table_.size() > std::size_t{1} << (32 - NeighbourView::chunk_bits))
    throw std::length_error("more than four billion neighbours; use a larger fluid.spacing");
}

std::size_t NeighbourLists::memory_bytes() const {
  std::size_t bytes = bytes_of(place_, table_, chunks_) +
                      chunks_.size() * NeighbourView::chunk_size * sizeof(std::uint32_t);
  for (const auto& list : large_)
    bytes += bytes_of(list);
  return bytes;
}

}  // namespace spindrift::sim::inline openmp
