#include "app/sweep/latin_hypercube.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <utility>

namespace spindrift::app {
namespace {

/// A random number in [0, 1). It is the same on every machine, which
/// std::uniform_real_distribution does not guarantee.
double fraction(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.;
}

/// The numbers 0 ... count - 1 in random order (Fisher and Yates).
std::vector<int> shuffled(int count, std::mt19937& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<int>(i);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(fraction(random) * double(i))]);
  return order;
}

/// The value at a part, 0 ... 1, of a range. It is rounded to four digits, since it is to be read
/// in the name of the run's folder.
Json value_at(const SampledRange& range, double part) {
  double value = range.scale == RangeScale::logarithmic
                     ? range.min * std::pow(range.max / range.min, part)
                     : range.min + part * (range.max - range.min);
  if (range.whole)
    return static_cast<long>(std::floor(range.min + part * (range.max - range.min + 1)));
  value = std::stod(fmt::format("{:.4g}", value));
  return std::min(std::max(value, range.min), range.max);
}

}  // namespace

void SampledRange::check(const Complain& complain) const {
  constexpr double most = 1'000'000;  // largest magnitude of the ends of a range of whole numbers
  if (min >= max)
    complain("max", "must be above min");
  for (const auto& [key, end] : {std::pair("min", min), std::pair("max", max)})
    if (whole && (std::floor(end) < end || std::abs(end) > most))
      complain(key, fmt::format("{} is out of range; accepted: whole numbers, {} ... {}", end,
                                -most, most));
  if (scale == RangeScale::logarithmic && (min <= 0 || whole))
    complain("scale", "logarithmic needs a min above 0, and numbers that need not be whole");
}

SweepAxis samples_of(const LatinHypercube& hypercube) {
  std::mt19937 random(static_cast<unsigned>(hypercube.seed));
  SweepAxis axis(static_cast<std::size_t>(hypercube.samples));
  for (const auto& [key, range, place] : hypercube.ranges) {
    const std::vector<int> parts = shuffled(hypercube.samples, random);
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const double part = (parts[i] + fraction(random)) / hypercube.samples;
      axis[i].push_back({key, value_at(range, part), place});
    }
  }
  return axis;
}

}  // namespace spindrift::app
