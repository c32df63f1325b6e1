// Memory that the device and the processor both see: CUDA's managed memory, whose pages move to the
// side that touches them. A time step touches it on the device only; setting up and taking frames
// read and write it on the processor.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace spindrift::sim::inline device {

/// @throws std::runtime_error when the device has too little memory
void* allocate(std::size_t bytes);
void release(void* memory) noexcept;

/// Bytes that are free; where the processor's cores are the device, more than there ever are.
std::size_t free_memory();

/// Of a particle of a large liquid: walls, lists and working memory included.
constexpr double bytes_per_particle = 500;

/// @param spacing of the particles, m @param free bytes
/// @throws std::runtime_error where so many particles do not fit: how many would, how far apart
void check_room(std::size_t particles, float spacing, std::size_t free);

/// Waits until the device has done all that it was given. The processor may read and write then.
/// @throws std::runtime_error when something went wrong there
void wait();

/// @throws std::runtime_error when what was last given to the device cannot begin
void check_launch();

/// Waits, and copies out of the device's memory, which stays where it is.
void copy_out(void* to, const void* from, std::size_t bytes);

/// Copies into the device's memory, after all that the device was given before; the processor may
/// write over its own numbers again at once.
void copy_in(void* to, const void* from, std::size_t bytes);

/// One number of the device's.
template <class T>
T fetched(const T* from) {
  T value;
  copy_out(&value, from, sizeof value);
  return value;
}

/// Working memory of the algorithms: blocks are kept and given again, so that a step allocates
/// nothing once its first ones are done.
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
  std::mutex mutex_;  ///< where the processor's cores are the device, they ask at the same time
  std::vector<Block> blocks_;
};

}  // namespace spindrift::sim::inline device
