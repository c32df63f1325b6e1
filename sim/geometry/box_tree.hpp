// A bounding volume hierarchy of axis-aligned boxes. It answers which boxes touch a given one, for
// work that is done once at the start of a run.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A binary tree of bounding boxes over a fixed list of boxes. Its nodes lie in depth-first order.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// The box with this index in the constructor's list.
  const Box& operator[](std::uint32_t number) const { return boxes_[number]; }

  /// Replaces `numbers` by the indices of all boxes that have a point in common with `box`, in
  /// ascending order.
  void find(const Box& box, std::vector<std::uint32_t>& numbers) const;

 private:
  struct Node {
    Box bounds;                ///< around all boxes below this node, m
    std::uint32_t begin, end;  ///< the leaf's range of numbers_; empty for an inner node
    std::uint32_t after;       ///< index of the next node that is not below this one
  };
  void build(std::uint32_t begin, std::uint32_t end);
  void build_halves(const Box& bounds, std::uint32_t begin, std::uint32_t end);

  std::vector<Box> boxes_;              ///< m
  std::vector<std::uint32_t> numbers_;  ///< indices of boxes, leaf after leaf
  std::vector<Node> nodes_;
};

}  // namespace spindrift::geometry
