// Thrust on the device that this is compiled for: CUDA, or, where a plain C++ compiler reads it,
// the processor's cores by THRUST_DEVICE_SYSTEM_OMP, on which the tests run.
#pragma once

#include <thrust/copy.h>
#include <thrust/execution_policy.h>
#include <thrust/for_each.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/scan.h>
#include <thrust/sort.h>
#include <thrust/transform_reduce.h>

#include <bit>
#include <cstdint>
#ifdef __CUDACC__
#include <cub/device/device_radix_sort.cuh>
#endif

#include "sim/device/memory.hpp"

namespace spindrift::sim::inline device {

using Counting = thrust::counting_iterator<std::uint32_t>;

/// f(i) for i in [0, n), begun after all that was begun before; returns at once.
template <class F>
void launch(std::uint32_t n, F f) {
#ifdef __CUDACC__
  thrust::for_each_n(thrust::cuda::par_nosync, Counting(0), n, f);
#else
  thrust::for_each_n(thrust::device, Counting(0), n, f);
#endif
}

/// Sorts values by keys of so many bits; equal keys keep their order. The other two arrays are room
/// for as many; where the sorted ones are is in the pointers afterwards.
template <class Key>
void sort_pairs(Scratch& scratch, std::uint32_t n, [[maybe_unused]] int bits, Key*& keys,
                [[maybe_unused]] Key*& other_keys, std::uint32_t*& values,
                [[maybe_unused]] std::uint32_t*& other_values) {
#ifdef __CUDACC__
  cub::DoubleBuffer<Key> key_buffer(keys, other_keys);
  cub::DoubleBuffer<std::uint32_t> value_buffer(values, other_values);
  std::size_t bytes = 0;
  cub::DeviceRadixSort::SortPairs(nullptr, bytes, key_buffer, value_buffer, n, 0, bits);
  char* room = scratch.allocate(static_cast<std::ptrdiff_t>(bytes));
  cub::DeviceRadixSort::SortPairs(room, bytes, key_buffer, value_buffer, n, 0, bits);
  scratch.deallocate(room, bytes);
  keys = key_buffer.Current();
  other_keys = key_buffer.Alternate();
  values = value_buffer.Current();
  other_values = value_buffer.Alternate();
#else
  thrust::stable_sort_by_key(thrust::device(scratch), keys, keys + n, values);
#endif
}

/// Bits of the numbers below n.
inline int bits_below(std::uint64_t n) {
  return static_cast<int>(std::bit_width(n));
}

}  // namespace spindrift::sim::inline device
