// Boxes found by place, for what is done once at the start of a run.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// Boxes in a tree of boxes, whose nodes are followed by those below them.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  const Box& operator[](std::uint32_t number) const { return boxes_[number]; }

  /// Numbers of the boxes that have a point in common with this one, smallest first.
  void find(const Box& box, std::vector<std::uint32_t>& numbers) const;

 private:
  struct Node {
    Box bounds;                ///< m
    std::uint32_t begin, end;  ///< of numbers_; none but in leaves
    std::uint32_t after;       ///< the next node that is not below this one
  };
  void build(std::uint32_t begin, std::uint32_t end);
  void build_halves(const Box& bounds, std::uint32_t begin, std::uint32_t end);

  std::vector<Box> boxes_;  ///< m
  std::vector<std::uint32_t> numbers_;
  std::vector<Node> nodes_;
};

}  // namespace spindrift::geometry
