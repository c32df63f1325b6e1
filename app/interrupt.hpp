// Ctrl-C as a flag: the first one asks a run to end well, the second ends it at once.
#pragma once

#include <atomic>

namespace spindrift::app {

class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static const std::atomic<bool>& requested();
};

}  // namespace spindrift::app
