// A queue of limited length between two threads. A full queue makes the giver wait, so that a fast
// stage of the pipeline does not pile up frames before a slow one.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace spindrift::app {

/// A first-in, first-out queue that any thread may use.
template <class T>
class BoundedQueue {
 public:
  /// @param capacity the largest number of items in the queue
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Appends an item, and waits while the queue is full.
  /// @return false when the queue has been closed; the item is then dropped
  bool push(T value) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
    if (closed_)
      return false;
    items_.push_back(std::move(value));
    changed_.notify_all();
    return true;
  }

  /// Takes the oldest item, and waits while there is none.
  /// @return nothing when the queue is closed and empty
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !items_.empty(); });
    if (items_.empty())
      return std::nullopt;
    std::optional<T> value(std::move(items_.front()));
    items_.pop_front();
    changed_.notify_all();
    return value;
  }

  /// Closes the queue: it takes no more items and nobody waits any longer, but the items in it can
  /// still be popped.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<T> items_;
  std::size_t capacity_;
  bool closed_ = false;
};

}  // namespace spindrift::app
