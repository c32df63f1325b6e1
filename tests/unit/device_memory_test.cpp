// Memory on the device.
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "sim/backend/backend.hpp"

namespace device_memory_tests {

using namespace spindrift::sim;
using Catch::Matchers::Contains;

TEST_CASE("memory that the device does not have is an error that says how much is missing") {
  CHECK_THROWS_WITH(allocate(std::size_t{1} << 56), Contains("too little memory") &&
                                                        Contains("72057594038 MB") &&
                                                        Contains("fluid.spacing"));
}

TEST_CASE("a liquid that the device has no room for is an error that says what would fit") {
  constexpr std::size_t room = 8'000'000'000;
  const auto fitting = static_cast<std::size_t>(double{room} / bytes_per_particle);
  CHECK_NOTHROW(check_room(fitting, 0.01f, room));
  // Eight times as many: twice the spacing.
  CHECK_THROWS_WITH(check_room(8 * fitting, 0.01f, room),
                    Contains(std::to_string(8 * fitting) + " particles") && Contains("8000 MB") &&
                        Contains("room for " + std::to_string(fitting)) &&
                        Contains("fluid.spacing of 0.0202 m"));
}

TEST_CASE("working memory is given again") {
  Scratch scratch;
  char* const first = scratch.allocate(1000);
  char* const second = scratch.allocate(5000);
  CHECK(first != second);
  const std::size_t bytes = scratch.memory_bytes();
  scratch.deallocate(second, 5000);
  scratch.deallocate(first, 1000);
  CHECK(scratch.allocate(900) == first);
  CHECK(scratch.allocate(4000) == second);
  CHECK(scratch.memory_bytes() == bytes);
}

TEST_CASE("an array keeps its values when it grows, and its memory when it shrinks") {
  Array<std::uint32_t> array;
  CHECK(array.empty());
  array.resize(100, 7);
  for (std::uint32_t k = 0; k < 100; ++k)
    array[k] = k;
  array.resize(5000, 3);
  CHECK(array[99] == 99);
  CHECK(array[100] == 3);
  CHECK(array[4999] == 3);
  const std::size_t capacity = array.capacity();
  array.renew(10);
  CHECK(array.size() == 10);
  CHECK(array.capacity() == capacity);
}

}  // namespace device_memory_tests
