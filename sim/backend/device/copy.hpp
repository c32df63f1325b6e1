// Numbers for the processor to look at later, as they were when their copy was begun: they are
// packed on the device in turn with all else, and cross over beside the loops that come after.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace spindrift::sim::inline device {

/// A block on the device, and one in the processor's memory to which its contents go, in a CUDA
/// stream of its own.
class CopyRoom {
 public:
  /// @throws std::runtime_error when the device or the machine has too little memory
  explicit CopyRoom(std::size_t bytes);

  std::size_t bytes() const { return bytes_; }
  void* on_device() { return on_device_.get(); }
  /// Begins to copy the first `bytes`, after all that the device was given before; it does not
  /// wait for the copy when it is given more.
  void send(std::size_t bytes);
  /// Where they are, once they are there: waits for them alone. Any thread may ask.
  const void* received() const;

 private:
  using Owned = std::unique_ptr<void, void (*)(void*)>;

  std::size_t bytes_;
  Owned on_device_, on_host_;
  Owned packed_, stream_;  ///< a CUDA event and stream
};

/// n numbers on their way. It may outlive what it was copied from.
template <class T>
class Copy {
 public:
  Copy(std::shared_ptr<CopyRoom> room, std::uint32_t n) : room_(std::move(room)), n_(n) {}

  /// The numbers, once; waits until they are there.
  std::vector<T> take() {
    const std::shared_ptr<CopyRoom> room = std::move(room_);
    const T* const values = static_cast<const T*>(room->received());
    return {values, values + n_};
  }

 private:
  std::shared_ptr<CopyRoom> room_;
  std::uint32_t n_;
};

/// Rooms of copies: kept, and given again when nobody holds them any more.
class CopyRooms {
 public:
  std::shared_ptr<CopyRoom> take(std::size_t bytes);
  /// On the device.
  std::size_t memory_bytes() const;

 private:
  std::vector<std::shared_ptr<CopyRoom>> rooms_;
};

}  // namespace spindrift::sim::inline device
