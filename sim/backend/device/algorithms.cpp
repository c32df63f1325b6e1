#include "sim/backend/device/algorithms.hpp"

#include <thrust/copy.h>
#include <thrust/execution_policy.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/scan.h>
#include <thrust/sort.h>

#include <bit>
#ifdef __CUDACC__
#include <cub/device/device_radix_sort.cuh>
#endif

#include "sim/geometry/host_device.hpp"

namespace spindrift::sim::inline device {
namespace {

struct IsSet {
  SPINDRIFT_HD bool operator()(std::uint8_t flag) const { return flag != 0; }
};

template <class Key>
void sort(Scratch& scratch, std::uint32_t n, [[maybe_unused]] int bits, Key*& keys,
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
  check_launch();
  keys = key_buffer.Current();
  other_keys = key_buffer.Alternate();
  values = value_buffer.Current();
  other_values = value_buffer.Alternate();
#else
  thrust::stable_sort_by_key(thrust::device(scratch), keys, keys + n, values);
#endif
}

}  // namespace

void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint64_t*& keys,
                std::uint64_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values) {
  sort(scratch, n, bits, keys, other_keys, values, other_values);
}

void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint32_t*& keys,
                std::uint32_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values) {
  sort(scratch, n, bits, keys, other_keys, values, other_values);
}

void sum_up(Scratch& scratch, std::uint64_t* numbers, std::uint32_t n) {
  thrust::exclusive_scan(thrust::device(scratch), numbers, numbers + n, numbers);
}

std::uint32_t find_flagged(Scratch& scratch, const std::uint8_t* flags, std::uint32_t n,
                           std::uint32_t* found) {
  const thrust::counting_iterator<std::uint32_t> begin(0);
  const std::uint32_t* const end =
      thrust::copy_if(thrust::device(scratch), begin, begin + n, flags, found, IsSet{});
  return static_cast<std::uint32_t>(end - found);
}

int bits_below(std::uint64_t n) {
  return static_cast<int>(std::bit_width(n));
}

}  // namespace spindrift::sim::inline device
