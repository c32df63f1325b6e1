// Errors of the device, thrown as exceptions.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace spindrift::sim::inline device {

/// Reports that the device has too little memory.
/// @param bytes number of bytes more that are needed
/// @param free  number of bytes that are free
/// @throws std::runtime_error always
[[noreturn]] inline void too_little_memory(std::size_t bytes, std::size_t free) {
  const auto megabytes = [](std::size_t n) { return std::to_string((n + 999'999) / 1'000'000); };
  throw std::runtime_error("the device has too little memory: " + megabytes(bytes) +
                           " MB more are needed, " + megabytes(free) +
                           " MB are free; use a larger fluid.spacing, or the backend \"cpu\"");
}

#ifdef __CUDACC__
/// @throws std::runtime_error unless a CUDA call succeeded
inline void check(cudaError_t error) {
  if (error != cudaSuccess)
    throw std::runtime_error(std::string("CUDA: ") + cudaGetErrorString(error));
}
#endif

}  // namespace spindrift::sim::inline device
