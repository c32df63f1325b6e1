// Copies of numbers from the device, as they are when the copy begins, for the host to use later.
// They are packed on the device in turn with all other loops, and cross over while later loops run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace spindrift::sim::inline device {

/// A block of device memory, and a block of host memory to which its contents are copied in a CUDA
/// stream of its own.
class CopyRoom {
 public:
  /// @throws std::runtime_error when the device or the machine has too little memory
  explicit CopyRoom(std::size_t bytes);

  std::size_t bytes() const { return bytes_; }
  void* on_device() { return on_device_.get(); }
  /// Begins to copy the first `bytes` to the host, after all that the device was given before. What
  /// the device is given later does not wait for the copy.
  void send(std::size_t bytes);
  /// Waits for the copy alone, and returns the host's block. Any thread may call it.
  const void* received() const;

 private:
  using Owned = std::unique_ptr<void, void (*)(void*)>;

  std::size_t bytes_;
  Owned on_device_, on_host_;
  Owned packed_, stream_;  ///< CUDA event after packing, and stream of the copy
};

/// An array of n elements on its way to the host. It may outlive the array that it is copied from.
template <class T>
class Copy {
 public:
  Copy(std::shared_ptr<CopyRoom> room, std::uint32_t n) : room_(std::move(room)), n_(n) {}

  /// Waits for the elements and returns them. To be called once.
  std::vector<T> take() {
    const std::shared_ptr<CopyRoom> room = std::move(room_);
    const T* const values = static_cast<const T*>(room->received());
    return {values, values + n_};
  }

 private:
  std::shared_ptr<CopyRoom> room_;
  std::uint32_t n_;
};

/// A pool of CopyRooms, which are used again when no Copy holds them any more.
class CopyRooms {
 public:
  /// A free room of at least `bytes`.
  std::shared_ptr<CopyRoom> take(std::size_t bytes);
  /// Device memory of all rooms, bytes.
  std::size_t memory_bytes() const;

 private:
  std::vector<std::shared_ptr<CopyRoom>> rooms_;
};

}  // namespace spindrift::sim::inline device
