// Boxes found by place.
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "sim/geometry/box_tree.hpp"
#include "sim/geometry/shape.hpp"

namespace geometry_box_tree_tests {

using namespace spindrift::geometry;

namespace {

std::vector<Box> random_boxes(std::size_t count, float largest) {
  std::mt19937 numbers(7);
  std::uniform_real_distribution<float> place(0, 1), size(0, largest);
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::vec3 min(place(numbers), place(numbers), place(numbers));
    boxes.push_back({min, min + glm::vec3(size(numbers), size(numbers), size(numbers))});
  }
  return boxes;
}

}  // namespace

TEST_CASE("a tree of boxes finds those that looking at each one finds, smallest number first") {
  const std::size_t count = GENERATE(0, 1, 4, 5, 300);
  const std::vector<Box> boxes = random_boxes(count, 0.2f);
  const BoxTree tree(boxes);
  std::vector<std::uint32_t> found;
  for (const Box& wanted : random_boxes(50, 0.3f)) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
      if (!is_apart(boxes[k], wanted))
        expected.push_back(k);
    tree.find(wanted, found);
    CHECK(found == expected);
  }
}

TEST_CASE("a tree of boxes finds all that lie in one place, and what only touches") {
  const BoxTree tree(std::vector<Box>(1000, Box{glm::vec3(0), glm::vec3(1)}));
  std::vector<std::uint32_t> found;
  tree.find({glm::vec3(1), glm::vec3(2)}, found);
  CHECK(found.size() == 1000);
  tree.find({glm::vec3(1.01f), glm::vec3(2)}, found);
  CHECK(found.empty());
}

}  // namespace geometry_box_tree_tests
