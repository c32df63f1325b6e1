// Loops and reductions on the device: a GPU, or, where a plain C++ compiler reads this, the CPU's
// cores by Thrust's OpenMP system, on which the tests run.
//
// The GPU's kernels are written here so that each has the body of its loop once. Thrust's
// algorithms for a GPU have it sixteen times and more: nine tenths of the time to compile them, and
// of the code.
#pragma once

#include <cstdint>
#ifdef __CUDACC__
#include <cub/block/block_reduce.cuh>
#else
#include <thrust/execution_policy.h>
#include <thrust/for_each.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/transform_reduce.h>
#endif

#include "sim/backend/device/memory.hpp"
#include "sim/geometry/host_device.hpp"

namespace spindrift::sim::inline device {

/// T::join() as a binary function.
template <class T>
struct Join {
  SPINDRIFT_HD T operator()(T a, const T& b) const {
    a.join(b);
    return a;
  }
};

#ifdef __CUDACC__

constexpr std::uint32_t loop_threads = 128;        ///< threads per block
constexpr std::uint32_t most_partial_sums = 4096;  ///< most blocks of a reduction

template <class F>
__global__ void __launch_bounds__(loop_threads) run_loop(std::uint32_t n, F f) {
  const std::uint32_t i = blockIdx.x * loop_threads + threadIdx.x;
  if (i < n)
    f(i);
}

/// Joins f(i) for the indices i of each block, and calls store(block, total) once per block.
template <class T, class F, class Store>
__global__ void __launch_bounds__(loop_threads) join_blocks(std::uint32_t n, F f, Store store) {
  using BlockReduce = cub::BlockReduce<T, loop_threads>;
  __shared__ typename BlockReduce::TempStorage storage;
  T sum{};
  for (std::size_t i = blockIdx.x * loop_threads + threadIdx.x; i < n;
       i += std::size_t{gridDim.x} * loop_threads)
    sum.join(f(static_cast<std::uint32_t>(i)));
  sum = BlockReduce(storage).Reduce(sum, Join<T>{});
  if (threadIdx.x == 0)
    store(blockIdx.x, sum);
}

/// The totals of the blocks: it stores them, and is the function that returns them again.
template <class T>
struct Partial {
  T* values;
  __device__ T operator()(std::uint32_t i) const { return values[i]; }
  __device__ void operator()(std::uint32_t i, const T& value) const { values[i] = value; }
};

/// Passes the total of the only block to a function.
template <class T, class Use>
struct UseTotal {
  Use use;
  __device__ void operator()(std::uint32_t, const T& total) const { use(total); }
};

/// Calls f(i) on the device for i in [0, n), after all that was begun before; returns at once.
template <class F>
void launch(std::uint32_t n, F f) {
  if (n == 0)
    return;
  run_loop<<<(n - 1) / loop_threads + 1, loop_threads>>>(n, f);
  check_launch();
}

/// Joins f(i) for i in [0, n), in an order that depends on n alone, and calls use(total) on the
/// device; returns at once.
template <class T, class F, class Use>
void join_and(Scratch& scratch, std::uint32_t n, F f, Use use) {
  const std::uint32_t wanted = n == 0 ? 1 : (n - 1) / loop_threads + 1;
  const std::uint32_t blocks = wanted < most_partial_sums ? wanted : most_partial_sums;
  if (blocks == 1) {
    join_blocks<T><<<1, loop_threads>>>(n, f, UseTotal<T, Use>{use});
  } else {
    const std::size_t bytes = blocks * sizeof(T);
    char* const room = scratch.allocate(static_cast<std::ptrdiff_t>(bytes));
    const Partial<T> partial{reinterpret_cast<T*>(room)};
    join_blocks<T><<<blocks, loop_threads>>>(n, f, partial);
    join_blocks<T><<<1, loop_threads>>>(blocks, partial, UseTotal<T, Use>{use});
    scratch.deallocate(room, bytes);
  }
  check_launch();
}

#else

template <class F>
void launch(std::uint32_t n, F f) {
  thrust::for_each_n(thrust::device, thrust::counting_iterator<std::uint32_t>(0), n, f);
}

template <class T, class F, class Use>
void join_and(Scratch& scratch, std::uint32_t n, F f, Use use) {
  const thrust::counting_iterator<std::uint32_t> begin(0);
  use(thrust::transform_reduce(thrust::device(scratch), begin, begin + n, f, T{}, Join<T>{}));
}

#endif

}  // namespace spindrift::sim::inline device
