// Latin hypercube sampling: values of several keys of a scene, spread evenly over a range of each.
#pragma once

#include <limits>
#include <vector>

#include "app/sweep/sweep_plan.hpp"
#include "app/tables/table.hpp"

namespace spindrift::app {

/// The scale on which a range is cut into equal parts.
enum class RangeScale { linear, logarithmic };
template <>
inline constexpr std::array<std::string_view, 2> value_names<RangeScale>{"linear", "logarithmic"};

/// The range of one key's values. Its ends are NaN until they are read.
struct SampledRange {
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  RangeScale scale = RangeScale::linear;
  bool whole = false;  ///< whole numbers only

  /// Reports ends that are out of order, and those that do not fit `scale` or `whole`.
  void check(const Complain& complain) const;
};

/// A Latin hypercube (McKay, Beckman, Conover 1979): each range is cut into as many parts as there
/// are samples, and one sample lies in each part.
struct LatinHypercube {
  int samples = 2;
  int seed = 1;  ///< seed of the random numbers
  std::vector<Keyed<SampledRange>> ranges;
};

template <>
inline constexpr auto table<SampledRange> = std::tuple{
    Field{"min", &SampledRange::min, "the least value", any_number, {}, Presence::required},
    Field{"max", &SampledRange::max, "the largest value", any_number, {}, Presence::required},
    Field{"scale", &SampledRange::scale, "in what the parts of the range are equal"},
    Field{"whole", &SampledRange::whole, "whole numbers only"}};

template <>
inline constexpr auto table<LatinHypercube> = std::tuple{
    Field{"samples",
          &LatinHypercube::samples,
          "how many runs, and parts of each range",
          Range{2, 10'000},
          {},
          Presence::required},
    Field{"seed", &LatinHypercube::seed, "another seed draws other values", Range{0, 2e9}},
    Field{"ranges",
          &LatinHypercube::ranges,
          "ranges of values, by key of the scene",
          {},
          {},
          Presence::required}};

/// Draws the samples, each with a value of every key. A seed gives the same samples on every
/// machine.
SweepAxis samples_of(const LatinHypercube& hypercube);

}  // namespace spindrift::app
