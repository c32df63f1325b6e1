#include <fmt/format.h>

#include <cmath>
#include <random>
#include <utility>

#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {
namespace {

/// In [0, 1), the same on every machine (std::uniform_real_distribution is not).
double fraction(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.;
}

/// 0 ... count - 1 in random order (Fisher and Yates).
std::vector<int> shuffled(int count, std::mt19937& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<int>(i);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(fraction(random) * double(i))]);
  return order;
}

/// Four digits, since it is to be read in the folder's name.
Json value_at(const SampledRange& range, double part) {
  double value = range.logarithmic ? range.min * std::pow(range.max / range.min, part)
                                   : range.min + part * (range.max - range.min);
  if (range.whole)
    return static_cast<long>(std::floor(range.min + part * (range.max - range.min + 1)));
  value = std::stod(fmt::format("{:.4g}", value));
  return std::min(std::max(value, range.min), range.max);
}

}  // namespace

SweepAxis latin_hypercube(const std::vector<SampledRange>& ranges, int samples, unsigned seed) {
  std::mt19937 random(seed);
  SweepAxis axis(static_cast<std::size_t>(samples));
  for (const SampledRange& range : ranges) {
    const std::vector<int> parts = shuffled(samples, random);
    for (std::size_t i = 0; i < axis.size(); ++i)
      axis[i].push_back(
          {range.key, value_at(range, (parts[i] + fraction(random)) / samples), range.place});
  }
  return axis;
}

}  // namespace spindrift::app
