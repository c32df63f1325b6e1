// Encodes the cells of a sparse grid as sortable 64-bit keys, so that empty space costs no memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace spindrift::surface {

/// Bits of a key given to each axis; cell coordinates lie in [0, 2^21).
inline constexpr int axis_bits = 21;

/// Returns the key of a cell with no negative coordinate. Keys sort by z, then y, then x, so that
/// cells which follow each other along x have consecutive keys.
inline std::uint64_t grid_key(const glm::ivec3& cell) {
  return (std::uint64_t(cell.z) << (2 * axis_bits)) | (std::uint64_t(cell.y) << axis_bits) |
         std::uint64_t(cell.x);
}

/// Returns the cell that has this key.
inline glm::ivec3 grid_cell(std::uint64_t key) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << axis_bits) - 1;
  return {int(key & mask), int((key >> axis_bits) & mask), int(key >> (2 * axis_bits))};
}

/// The index of an item, with the key to sort it by.
struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key, keeping the order of equal keys.
inline void sort_by_key(std::vector<KeyedIndex>& items) {
  std::ranges::stable_sort(items, {}, &KeyedIndex::key);
}

}  // namespace spindrift::surface
