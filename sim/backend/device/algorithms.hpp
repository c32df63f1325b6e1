// Sorting, summing up and selecting on the device, by Thrust and CUB, whose headers and kernels are
// compiled in one source alone.
#pragma once

#include <cstdint>

#include "sim/backend/device/memory.hpp"

namespace spindrift::sim::inline device {

/// Sorts values by keys of so many bits; equal keys keep their order. The other two arrays are room
/// for as many; where the sorted ones are is in the pointers afterwards.
void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint64_t*& keys,
                std::uint64_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values);
void sort_pairs(Scratch& scratch, std::uint32_t n, int bits, std::uint32_t*& keys,
                std::uint32_t*& other_keys, std::uint32_t*& values, std::uint32_t*& other_values);

/// Puts, in place of each of n numbers, the sum of those before it.
void sum_up(Scratch& scratch, std::uint64_t* numbers, std::uint32_t n);

/// Writes the i in [0, n) for which flags[i] is not 0, in order; returns how many.
std::uint32_t find_flagged(Scratch& scratch, const std::uint8_t* flags, std::uint32_t n,
                           std::uint32_t* found);

/// Bits of the numbers below n.
int bits_below(std::uint64_t n);

}  // namespace spindrift::sim::inline device
