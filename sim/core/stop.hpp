// Giving up what takes long.
#pragma once

#include <atomic>
#include <stdexcept>

namespace spindrift::sim {

/// Becomes true when what goes on is no longer wanted; null: never.
using Stop = const std::atomic<bool>*;

/// What ends work that is no longer wanted.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

inline bool is_stopped(Stop stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// @throws Stopped
inline void throw_if_stopped(Stop stop) {
  if (is_stopped(stop))
    throw Stopped();
}

}  // namespace spindrift::sim
