#include "sim/backend/device/copy.hpp"

#include <algorithm>
#include <atomic>

#include "sim/backend/device/errors.hpp"
#include "sim/backend/device/memory.hpp"

namespace spindrift::sim::inline device {

#ifdef __CUDACC__

namespace {

void* device_block(std::size_t bytes) {
  void* memory = nullptr;
  const cudaError_t error = cudaMalloc(&memory, bytes);
  if (error == cudaErrorMemoryAllocation)
    too_little_memory(bytes, free_memory());
  check(error);
  return memory;
}

/// Pinned host memory, to which the device can copy without the host.
void* host_block(std::size_t bytes) {
  void* memory = nullptr;
  check(cudaMallocHost(&memory, bytes));
  return memory;
}

cudaEvent_t new_event() {
  cudaEvent_t event = nullptr;
  check(cudaEventCreateWithFlags(&event, cudaEventDisableTiming));
  return event;
}

/// A stream for which loops, which run in the default stream, do not wait.
cudaStream_t new_stream() {
  cudaStream_t stream = nullptr;
  check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  return stream;
}

}  // namespace

CopyRoom::CopyRoom(std::size_t bytes)
    : bytes_(std::max<std::size_t>(bytes, 1)),
      on_device_(device_block(bytes_), [](void* memory) { cudaFree(memory); }),
      on_host_(host_block(bytes_), [](void* memory) { cudaFreeHost(memory); }),
      packed_(new_event(), [](void* event) { cudaEventDestroy(static_cast<cudaEvent_t>(event)); }),
      stream_(new_stream(), [](void* stream) {
        cudaStreamSynchronize(static_cast<cudaStream_t>(stream));
        cudaStreamDestroy(static_cast<cudaStream_t>(stream));
      }) {}

void CopyRoom::send(std::size_t bytes) {
  const auto event = static_cast<cudaEvent_t>(packed_.get());
  const auto stream = static_cast<cudaStream_t>(stream_.get());
  check(cudaEventRecord(event));
  check(cudaStreamWaitEvent(stream, event));
  if (bytes > 0)
    check(cudaMemcpyAsync(on_host_.get(), on_device_.get(), bytes, cudaMemcpyDeviceToHost, stream));
}

const void* CopyRoom::received() const {
  check(cudaStreamSynchronize(static_cast<cudaStream_t>(stream_.get())));
  return on_host_.get();
}

#else

CopyRoom::CopyRoom(std::size_t bytes)
    : bytes_(bytes),
      on_device_(allocate(bytes), release),
      on_host_(nullptr, release),
      packed_(nullptr, release),
      stream_(nullptr, release) {}

void CopyRoom::send(std::size_t) {}

const void* CopyRoom::received() const {
  return on_device_.get();
}

#endif

std::shared_ptr<CopyRoom> CopyRooms::take(std::size_t bytes) {
  const auto is_free = [](const auto& room) { return room.use_count() == 1; };
  const std::shared_ptr<CopyRoom>* best = nullptr;
  for (const auto& room : rooms_)
    if (is_free(room) && room->bytes() >= bytes &&
        (best == nullptr || room->bytes() < (*best)->bytes()))
      best = &room;
  if (best == nullptr) {
    // Free rooms that are too small would never be taken again.
    std::erase_if(rooms_, [&](const auto& room) { return is_free(room) && room->bytes() < bytes; });
    return rooms_.emplace_back(std::make_shared<CopyRoom>(bytes + bytes / 8));
  }
  // Orders the new use after all that the last holder, in any thread, did with the room.
  std::atomic_thread_fence(std::memory_order_acquire);
  return *best;
}

std::size_t CopyRooms::memory_bytes() const {
  std::size_t sum = 0;
  for (const auto& room : rooms_)
    sum += room->bytes();
  return sum;
}

}  // namespace spindrift::sim::inline device
