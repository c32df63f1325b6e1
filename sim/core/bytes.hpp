// The memory that data takes, summed up.
#pragma once

#include <cstddef>

namespace spindrift::sim {

/// Something that knows how much memory it has taken.
template <class T>
concept KnowsItsBytes = requires(const T& t) {
  t.memory_bytes();
};

/// The bytes of one object: as it says itself, or else, for an array (std::vector, or the
/// device's), those of its elements, with those that it has room for.
template <class T>
std::size_t bytes_of_one(const T& one) {
  if constexpr (KnowsItsBytes<T>) {
    return one.memory_bytes();
  } else if constexpr (KnowsItsBytes<typename T::value_type>) {
    std::size_t sum = 0;
    for (const auto& element : one)
      sum += element.memory_bytes();
    return sum;
  } else {
    return one.capacity() * sizeof(typename T::value_type);
  }
}

/// The bytes of some objects together.
template <class... T>
std::size_t bytes_of(const T&... all) {
  return (bytes_of_one(all) + ... + std::size_t{0});
}

}  // namespace spindrift::sim
