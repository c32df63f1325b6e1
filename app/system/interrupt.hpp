// Ctrl-C as a flag: the first one asks a run to end well, the second ends it at once. So do
// SIGTERM, and the loss of the terminal (SIGHUP), unless that is ignored, as nohup has it.
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

 private:
  void set(void (*handler)(int)) const;

  bool hears_hangup_;
};

}  // namespace spindrift::app
