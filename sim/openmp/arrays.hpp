// Arrays on the processor.
#pragma once

#include <vector>

#include "sim/real.hpp"

namespace spindrift::sim::inline openmp {

template <class T>
using Array = std::vector<T>;

/// Makes room for so many values; what they were is lost. Takes memory only where there is too
/// little, and then not twice as much, as vectors do.
template <class T>
void grow(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) {
    values = {};
    values.reserve(size + size / 8);
  }
  values.resize(size);
}

}  // namespace spindrift::sim::inline openmp
