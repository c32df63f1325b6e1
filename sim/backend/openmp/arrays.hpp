// Arrays on the processor.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/core/real.hpp"

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

/// Sets all values to one.
template <class T>
void set_all(std::vector<T>& values, const T& value) {
  std::fill(values.begin(), values.end(), value);
}

/// Takes over numbers of the processor's.
template <class T>
void put(std::vector<T>& values, const std::vector<T>& from) {
  values = from;
}

}  // namespace spindrift::sim::inline openmp
