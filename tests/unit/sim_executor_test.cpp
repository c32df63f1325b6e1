// The loops that solvers are written with, against plain ones.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/particles/particles.hpp"

namespace sim_executor_tests {

using namespace spindrift::sim;

namespace {

constexpr std::uint32_t count = 10000;

/// A number that looks like a random one, from 0 to below `end`.
SPINDRIFT_HD std::uint32_t scattered(std::uint32_t i, std::uint32_t end) {
  std::uint32_t x = (i + 1) * 2654435761u;
  x ^= x >> 15;
  x *= 2246822519u;
  return (x ^ x >> 13) % end;
}

/// What stands together is reduced together.
struct SumAndLargest {
  double sum = 0;
  float largest = 0;
  SPINDRIFT_HD void join(const SumAndLargest& other) {
    sum += other.sum;
    largest = largest < other.largest ? other.largest : largest;
  }
};

}  // namespace

TEST_CASE("a loop reaches every index once") {
  Executor executor;
  ScalarField field;
  field.resize(count);
  float* values = field.data();
  for (int round = 0; round < 2; ++round)
    executor.for_each("count", count, [=] SPINDRIFT_HD(std::uint32_t i) {
      values[i] += static_cast<float>(i % 7 + 1);
    });
  executor.for_each("nothing", 0, [=] SPINDRIFT_HD(std::uint32_t i) { values[i] = -1; });
  executor.wait();
  for (std::uint32_t i = 0; i < count; ++i)
    REQUIRE(field[i] == static_cast<float>(2 * (i % 7 + 1)));
  CHECK(field[count] == 0);
}

TEST_CASE("a reduction joins what the loop returns, all of it") {
  Executor executor;
  double sum = 0;
  float largest = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto value = static_cast<float>(scattered(i, 1000));
    sum += double{value};
    largest = std::max(largest, value);
  }
  const auto found =
      executor.reduce<SumAndLargest>("reduce", count, [=] SPINDRIFT_HD(std::uint32_t i) {
        const auto value = static_cast<float>(scattered(i, 1000));
        return SumAndLargest{double{value}, value};
      });
  CHECK(found.sum == sum);
  CHECK(found.largest == largest);
  const auto none =
      executor.reduce<Sum>("reduce", 0, [=] SPINDRIFT_HD(std::uint32_t) { return Sum{1.}; });
  CHECK(none.value == 0);
}

TEST_CASE("what a reduction leaves where the loops are is there for the next one") {
  Executor executor;
  Kept<SumAndLargest> kept;
  const auto one = [=] SPINDRIFT_HD(std::uint32_t i) {
    const auto value = static_cast<float>(scattered(i, 1000));
    return SumAndLargest{double{value}, value};
  };
  const auto take = [=] SPINDRIFT_HD(SumAndLargest & to, const SumAndLargest& total) {
    to = total;
  };
  for (const std::uint32_t n : {count, 100u}) {
    executor.reduce_to<SumAndLargest>("reduce", n, kept, one, take);
    const auto last = kept.view();
    const auto share = [=] SPINDRIFT_HD(std::uint32_t i) {
      return Sum{static_cast<double>(scattered(i, 1000)) / last->sum};
    };
    const auto note = [=] SPINDRIFT_HD(SumAndLargest & to, const Sum& total) {
      to.sum = total.value + static_cast<double>(to.largest);
    };
    executor.reduce_to<Sum>("reduce", n, kept, share, note);
    float largest = 0;
    for (std::uint32_t i = 0; i < n; ++i)
      largest = std::max(largest, static_cast<float>(scattered(i, 1000)));
    CHECK(kept.look().sum == Approx(1 + largest));
  }
}

TEST_CASE("what is copied stays as it was when the copy was begun, whenever it is looked at") {
  std::vector<Copy<float>> copies;
  {
    Executor executor;
    ScalarField field;
    field.resize(count);
    float* values = field.data();
    for (int round = 0; round < 5; ++round) {
      executor.for_each("count", count, [=] SPINDRIFT_HD(std::uint32_t i) {
        values[i] += static_cast<float>(i % 7);
      });
      // Fewer each time, then more, so that room is given again.
      const std::uint32_t n = count - 1000 * (round % 3);
      copies.push_back(executor.copy<float>(
          "copy", n, [=] SPINDRIFT_HD(std::uint32_t i) { return 2 * values[i]; }));
      if (round == 2)
        CHECK(copies[1].take().size() == count - 1000);
    }
    CHECK(executor.copy<float>("copy", 0, [=] SPINDRIFT_HD(std::uint32_t) { return 1.f; })
              .take()
              .empty());
  }
  for (const int round : {0, 2, 3, 4}) {
    const std::vector<float> taken = copies[static_cast<std::size_t>(round)].take();
    REQUIRE(taken.size() == count - 1000 * (round % 3));
    for (std::uint32_t i = 0; i < taken.size(); ++i)
      REQUIRE(taken[i] == static_cast<float>(2 * (round + 1) * (i % 7)));
  }
}

TEST_CASE("a selection holds the chosen indices in order") {
  Executor executor;
  Array<std::uint32_t> chosen;
  for (const std::uint32_t divisor : {3u, 1u, 20000u}) {
    executor.select("select", count, chosen, [=] SPINDRIFT_HD(std::uint32_t i) {
      return scattered(i, 20000) % divisor == 0;
    });
    executor.wait();
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < count; ++i)
      if (scattered(i, 20000) % divisor == 0)
        expected.push_back(i);
    CHECK(std::vector<std::uint32_t>(chosen.begin(), chosen.end()) == expected);
  }
}

TEST_CASE("terms are added at their places in their order") {
  Executor executor;
  constexpr std::uint32_t places = 300;
  ScalarField field;
  field.resize(places);
  std::vector<float> expected(places);
  for (std::uint32_t p = 0; p < places; ++p)
    expected[p] = field[p] = 0.1f * static_cast<float>(p);
  // Sums of such numbers depend on the order.
  const auto term = [=] SPINDRIFT_HD(std::uint32_t k) {
    return 1.f / static_cast<float>(scattered(k, 999) + 1);
  };
  for (std::uint32_t k = 0; k < count; ++k)
    expected[scattered(k, places / 2)] += term(k);
  executor.add_at_places(
      "add", count, field.data(), places,
      [=] SPINDRIFT_HD(std::uint32_t k) { return scattered(k, places / 2); }, term);
  executor.wait();
  for (std::uint32_t p = 0; p < places; ++p)
    REQUIRE(field[p] == expected[p]);
}

}  // namespace sim_executor_tests
