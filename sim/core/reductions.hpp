// Results that loops over particles reduce to (Executor::reduce): join() takes in another part.
#pragma once

#include <algorithm>

#include "sim/geometry/host_device.hpp"

namespace spindrift::sim {

/// A sum in double precision.
struct Sum {
  double value = 0;
  SPINDRIFT_HD void join(const Sum& other) { value += other.value; }
};

/// The largest of values that are not negative; 0 if there are none.
struct Largest {
  float value = 0;
  SPINDRIFT_HD void join(const Largest& other) { value = std::max(value, other.value); }
};

}  // namespace spindrift::sim
