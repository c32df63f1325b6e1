#include "sim/geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace spindrift::geometry {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), numbers_(boxes_.size()) {
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  if (!boxes_.empty())
    build(0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  Box bounds = boxes_[numbers_[begin]];
  for (std::uint32_t k = begin; k < end; ++k) {
    const Box& box = boxes_[numbers_[k]];
    bounds = {glm::min(bounds.min, box.min), glm::max(bounds.max, box.max)};
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back({bounds, begin, end, 0});
  if (end - begin > most_in_leaf) {
    nodes_[index].end = begin;
    build_halves(bounds, begin, end);
  }
  nodes_[index].after = static_cast<std::uint32_t>(nodes_.size());
}

void BoxTree::build_halves(const Box& bounds, std::uint32_t begin, std::uint32_t end) {
  const glm::vec3 size = bounds.max - bounds.min;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(numbers_.begin() + begin, numbers_.begin() + middle, numbers_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float of_a = boxes_[a].min[axis] + boxes_[a].max[axis];
                     const float of_b = boxes_[b].min[axis] + boxes_[b].max[axis];
                     return std::pair(of_a, a) < std::pair(of_b, b);
                   });
  build(begin, middle);
  build(middle, end);
}

void BoxTree::find(const Box& box, std::vector<std::uint32_t>& numbers) const {
  numbers.clear();
  for (std::uint32_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    const bool apart = is_apart(node.bounds, box);
    if (!apart)
      for (std::uint32_t k = node.begin; k < node.end; ++k)
        if (!is_apart(boxes_[numbers_[k]], box))
          numbers.push_back(numbers_[k]);
    n = apart ? node.after : n + 1;
  }
  std::sort(numbers.begin(), numbers.end());
}

}  // namespace spindrift::geometry
