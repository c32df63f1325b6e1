// Arrays of the OpenMP backend, which are vectors in the host's memory.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/core/bytes.hpp"

#include "sim/core/real.hpp"

namespace spindrift::sim::inline openmp {

template <class T>
using Array = std::vector<T>;

/// Resizes an array; the values of its elements may be lost. It allocates only where there is too
/// little memory, and then an eighth more than is needed, not twice as much as vectors do.
template <class T>
void grow(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) {
    values = {};
    values.reserve(size + size / 8);
  }
  values.resize(size);
}

/// Sets all elements to one value.
template <class T>
void set_all(std::vector<T>& values, const T& value) {
  std::fill(values.begin(), values.end(), value);
}

/// Copies a host vector into an array.
template <class T>
void put(std::vector<T>& values, const std::vector<T>& from) {
  values = from;
}

}  // namespace spindrift::sim::inline openmp
