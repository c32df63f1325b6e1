// Turns Ctrl-C (SIGINT) into a flag: the first asks a run to end in good order, the second ends it
// at once. SIGTERM does the same, and so does the loss of the terminal (SIGHUP), unless SIGHUP is
// ignored, as under nohup.
#pragma once

#include <atomic>

namespace spindrift::app {

/// Handles these signals as long as it lives. There must be at most one at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Becomes true when a signal asks the run to end.
  static const std::atomic<bool>& requested();

 private:
  void set(void (*handler)(int)) const;

  bool hears_hangup_;
};

}  // namespace spindrift::app
