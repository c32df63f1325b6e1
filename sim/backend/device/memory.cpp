#include "sim/backend/device/memory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>

#include "sim/backend/device/errors.hpp"

namespace spindrift::sim::inline device {
#ifdef __CUDACC__

std::size_t free_memory() {
  std::size_t free = 0, all = 0;
  check(cudaMemGetInfo(&free, &all));
  return free;
}

/// Managed memory may be larger than the device's, but would then be moved to and fro in each step.
/// So what does not fit is an error.
void* allocate(std::size_t bytes) {
  const std::size_t free = free_memory();
  if (bytes > free)
    too_little_memory(bytes, free);
  void* memory = nullptr;
  const cudaError_t error = cudaMallocManaged(&memory, std::max<std::size_t>(bytes, 1));
  if (error == cudaErrorMemoryAllocation)
    too_little_memory(bytes, free);
  check(error);
  return memory;
}

void release(void* memory) noexcept {
  cudaFree(memory);
}

void wait() {
  check(cudaDeviceSynchronize());
}

void check_launch() {
  check(cudaGetLastError());
}

void copy_out(void* to, const void* from, std::size_t bytes) {
  check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost));
}

/// A copy from pageable memory has read `from` before the call returns, so that the host may write
/// over it.
void copy_in(void* to, const void* from, std::size_t bytes) {
  if (bytes > 0)
    check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDefault));
}

#else

namespace {
constexpr std::align_val_t alignment{256};
}

std::size_t free_memory() {
  return std::numeric_limits<std::size_t>::max();
}

void* allocate(std::size_t bytes) {
  try {
    return ::operator new(bytes, alignment);
  } catch (const std::bad_alloc&) {
    too_little_memory(bytes, 0);
  }
}

void release(void* memory) noexcept {
  ::operator delete(memory, alignment);
}

void wait() {}

void check_launch() {}

void copy_out(void* to, const void* from, std::size_t bytes) {
  std::memcpy(to, from, bytes);
}

void copy_in(void* to, const void* from, std::size_t bytes) {
  if (bytes > 0)
    std::memcpy(to, from, bytes);
}

#endif

void check_room(std::size_t particles, float spacing, std::size_t free) {
  const auto count = static_cast<double>(particles), room = static_cast<double>(free),
             fitting = room / bytes_per_particle;
  if (count <= fitting)
    return;
  // The spacing at which the same volume holds as many particles as fit, rounded up to three
  // digits, with some room for how the volume is divided.
  const double wanted = 1.01 * double{spacing} * std::cbrt(count / fitting),
               digit = std::pow(10, std::floor(std::log10(wanted)) - 2);
  std::array<char, 400> text;
  std::snprintf(
      text.data(), text.size(),
      "the device has too little memory: %.0f particles need about %.0f MB, %.0f MB are "
      "free, which is room for %.0f particles; use a fluid.spacing of %g m or more, or the "
      "backend \"cpu\"",
      count, count * bytes_per_particle / 1e6, room / 1e6, std::floor(fitting),
      digit * std::ceil(wanted / digit));
  throw std::runtime_error(text.data());
}

Scratch::~Scratch() {
  for (const Block& block : blocks_)
    release(block.memory);
}

char* Scratch::allocate(std::ptrdiff_t bytes) {
  const std::lock_guard lock(mutex_);
  const auto size = static_cast<std::size_t>(bytes);
  Block* best = nullptr;
  for (Block& block : blocks_)
    if (!block.taken && block.bytes >= size && (best == nullptr || block.bytes < best->bytes))
      best = &block;
  if (best == nullptr) {
    // Free blocks that are too small would never be taken again.
    std::erase_if(blocks_, [](const Block& block) {
      if (!block.taken)
        release(block.memory);
      return !block.taken;
    });
    const std::size_t room = size + size / 8;
    best = &blocks_.emplace_back(Block{static_cast<char*>(device::allocate(room)), room, false});
  }
  best->taken = true;
  return best->memory;
}

void Scratch::deallocate(char* memory, std::size_t) noexcept {
  const std::lock_guard lock(mutex_);
  for (Block& block : blocks_)
    if (block.memory == memory)
      block.taken = false;
}

std::size_t Scratch::memory_bytes() const {
  std::size_t sum = 0;
  for (const Block& block : blocks_)
    sum += block.bytes;
  return sum;
}

}  // namespace spindrift::sim::inline device
