#include "sim/backend/device/neighbours.hpp"

#include <algorithm>

#include "sim/backend/device/algorithms.hpp"
#include "sim/backend/device/loops.hpp"

namespace spindrift::sim::inline device {
namespace {

/// The candidates for neighbours of the points of every cell: nine runs of other points each.
struct Candidates {
  const std::uint32_t* cell_of;              ///< cell of each point
  const std::uint32_t *run_begin, *run_end;  ///< runs, row by row, one per cell
  std::uint32_t cell_count;
  PointView others;
  float squared_radius;  ///< m²

  /// Calls f(j) for the candidates j that are closer to point i, at p, than the radius.
  template <class F>
  SPINDRIFT_HD void near(std::uint32_t i, const Vec3<float>& p, F f) const {
    for (std::uint32_t row = 0; row < 9; ++row) {
      const std::size_t at = row * cell_count + cell_of[i];
      const std::uint32_t end = run_end[at];
      for (std::uint32_t j = run_begin[at]; j < end; ++j) {
        const Vec3<float> d = p - others[j];
        if (dot(d, d) < squared_radius)
          f(j);
      }
    }
  }
};

/// Finds the cell of each point, and the runs of others in the 27 cells around each cell. The
/// others and the radius are still to be set.
Candidates find_candidates(const GridMap& map, const CellGridView& grid,
                           const CellGridView& other_grid, std::uint32_t* cell_of,
                           std::uint32_t* run_begin, std::uint32_t* run_end) {
  const std::uint32_t cells = grid.cell_count;
  launch(cells, [=] SPINDRIFT_HD(std::uint32_t c) {
    for (std::uint32_t i = grid.cell_begin(c); i < grid.cell_begin(c + 1); ++i)
      cell_of[i] = c;
  });
  launch(9 * cells, [=] SPINDRIFT_HD(std::uint32_t t) {
    const std::uint64_t low = map.row_key(grid.cell_key(t % cells), static_cast<int>(t / cells));
    std::uint32_t other = other_grid.first_cell_from(low);
    run_begin[t] = other_grid.cell_begin(other);
    while (other < other_grid.cell_count && other_grid.cell_key(other) <= low + 2)
      ++other;
    run_end[t] = other_grid.cell_begin(other);
  });
  return {cell_of, run_begin, run_end, cells, {}, 0};
}

}  // namespace

/// Neighbours are counted, then written: the search is done twice, and no list length is guessed.
void NeighbourLists::build(const GridMap& map, const CellGrid& grid, const PointView& points,
                           std::uint32_t count, const CellGrid& other_grid, const PointView& others,
                           std::uint32_t, float radius) {
  cell_of_.renew(count);
  run_begin_.renew(std::size_t{grid.cell_count()} * 9);
  run_end_.renew(std::size_t{grid.cell_count()} * 9);
  Candidates candidates = find_candidates(map, grid.view(), other_grid.view(), cell_of_.data(),
                                          run_begin_.data(), run_end_.data());
  candidates.others = others;
  candidates.squared_radius = radius * radius;
  counts_.renew(count);
  std::uint32_t* counts = counts_.data();
  launch(count, [=] SPINDRIFT_HD(std::uint32_t i) {
    std::uint32_t found = 0;
    candidates.near(i, points[i], [&](std::uint32_t) { ++found; });
    counts[i] = found;
  });

  const std::uint32_t groups = (count + lane_count - 1) / lane_count;
  begins_.renew(std::size_t{groups} + 1);
  std::uint64_t* begins = begins_.data();
  launch(groups + 1, [=] SPINDRIFT_HD(std::uint32_t g) {
    std::uint32_t longest = 0;
    for (std::uint32_t i = g * lane_count; i < (g + 1) * lane_count && i < count; ++i)
      longest = counts[i] > longest ? counts[i] : longest;
    begins[g] = longest;
  });
  sum_up(scratch_, begins, groups + 1);
  numbers_.renew(fetched(begins + groups) * lane_count);
  std::uint32_t* numbers = numbers_.data();
  launch(count, [=] SPINDRIFT_HD(std::uint32_t i) {
    std::uint32_t* at = numbers + begins[i / lane_count] * lane_count + i % lane_count;
    candidates.near(i, points[i], [&](std::uint32_t j) {
      *at = j;
      at += lane_count;
    });
  });
}

std::size_t NeighbourLists::memory_bytes() const {
  return bytes_of(scratch_, begins_, cell_of_, run_begin_, run_end_, counts_, numbers_);
}

}  // namespace spindrift::sim::inline device
