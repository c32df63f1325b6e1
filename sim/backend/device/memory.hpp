// Memory that the device and the host both see: CUDA's managed memory, whose pages move to the side
// that touches them. A time step touches it on the device, and on the host only where particles
// come or go; setting up a run reads and writes it on the host. Where the CPU's cores are the
// device, it is ordinary memory.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace spindrift::sim::inline device {

/// Allocates memory of the device. @throws std::runtime_error when it has too little
void* allocate(std::size_t bytes);
void release(void* memory) noexcept;

/// Free memory of the device, bytes; the largest number where the CPU's cores are the device.
std::size_t free_memory();

/// Memory per particle of a large liquid, with walls, neighbour lists and working memory, bytes.
constexpr double bytes_per_particle = 500;

/// Checks that a number of particles fits into the device's free memory.
/// @param spacing of the particles, m
/// @param free    free memory, bytes
/// @throws std::runtime_error if not; the message says how many particles fit, and at which spacing
void check_room(std::size_t particles, float spacing, std::size_t free);

/// Waits until the device has done all that it was given; then the host may access its memory.
/// @throws std::runtime_error when something went wrong on the device
void wait();

/// @throws std::runtime_error when the loop last given to the device could not begin
void check_launch();

/// Waits for the device, and copies from its memory to the host's, without moving managed pages.
void copy_out(void* to, const void* from, std::size_t bytes);

/// Copies from the host's memory into the device's, after all that the device was given before. The
/// host may write over `from` when the call returns.
void copy_in(void* to, const void* from, std::size_t bytes);

/// One value from the device's memory; waits for the device.
template <class T>
T fetched(const T* from) {
  T value;
  copy_out(&value, from, sizeof value);
  return value;
}

/// A pool of working memory for the algorithms, with the interface of an allocator that Thrust asks
/// for. Blocks are kept and used again, so that steps after the first ones allocate nothing.
class Scratch {
 public:
  using value_type = char;
  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();

  char* allocate(std::ptrdiff_t bytes);
  void deallocate(char* memory, std::size_t bytes) noexcept;
  std::size_t memory_bytes() const;

 private:
  struct Block {
    char* memory;
    std::size_t bytes;
    bool taken;
  };
  std::mutex mutex_;  ///< where the CPU's cores are the device, they allocate at the same time
  std::vector<Block> blocks_;
};

}  // namespace spindrift::sim::inline device
