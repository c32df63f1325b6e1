// Sorting, prefix sums and selection on the device, by Thrust and CUB, whose headers and kernels
// are compiled in one source alone.
#pragma once

#include <cstdint>

#include "sim/backend/device/memory.hpp"

namespace spindrift::sim::inline device {

/// Sorts n values by their keys; equal keys keep their order. The other two arrays are working
/// memory of the same size. Afterwards `keys` and `values` point to the sorted arrays, which may be
/// those that the other two pointers pointed to.
/// @param bits number of low bits that the keys use
void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint64_t*& keys,
                std::uint64_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values);
void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint32_t*& keys,
                std::uint32_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values);

/// Replaces each of n numbers by the sum of those before it (exclusive prefix sum).
void sum_up(Scratch& scratch, std::uint64_t* numbers, std::uint32_t n);

/// Writes the i in [0, n) for which flags[i] is not 0 to `found`, in order.
/// @return how many there are; the host waits for that
std::uint32_t find_flagged(Scratch& scratch, const std::uint8_t* flags, std::uint32_t n,
                           std::uint32_t* found);

/// Number of bits that hold every number below n.
int bits_below(std::uint64_t n);

}  // namespace spindrift::sim::inline device
