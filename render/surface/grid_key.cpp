#include "render/surface/grid_key.hpp"

#include <array>

namespace spindrift::surface {

void sort_by_key(std::vector<KeyedIndex>& items) {
  constexpr int digit_bits = 8;
  constexpr std::uint64_t mask = (1u << digit_bits) - 1;
  if (items.empty())
    return;
  std::uint64_t varying = 0;
  for (const KeyedIndex& item : items)
    varying |= item.key ^ items.front().key;

  std::vector<KeyedIndex> sorted(items.size());
  for (int shift = 0; shift < 64; shift += digit_bits) {
    if (((varying >> shift) & mask) == 0)
      continue;
    std::array<std::size_t, mask + 1> next{};
    for (const KeyedIndex& item : items)
      ++next[(item.key >> shift) & mask];
    std::size_t begin = 0;
    for (std::size_t& slot : next) {
      const std::size_t count = slot;
      slot = begin;
      begin += count;
    }
    for (const KeyedIndex& item : items)
      sorted[next[(item.key >> shift) & mask]++] = item;
    items.swap(sorted);
  }
}

}  // namespace spindrift::surface
