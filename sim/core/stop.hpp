// Cancelling work that takes long, from another thread.
#pragma once

#include <atomic>
#include <stdexcept>

namespace spindrift::sim {

/// A flag that becomes true when the work is no longer wanted; null: it is always wanted.
using Stop = const std::atomic<bool>*;

/// The exception that ends work that is no longer wanted.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

inline bool is_stopped(Stop stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// @throws Stopped when the flag is set
inline void throw_if_stopped(Stop stop) {
  if (is_stopped(stop))
    throw Stopped();
}

}  // namespace spindrift::sim
