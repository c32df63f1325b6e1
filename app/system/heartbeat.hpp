// Repeats a sign of life while something takes long, such as a progress line.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace spindrift::app {

/// Calls a function whenever nothing has been reported for a while.
class Heartbeat {
 public:
  /// Starts a thread that calls `say` whenever beat() has not been called for the time `quiet`, and
  /// again each time that `quiet` has passed. Where no thread can be started, `say` is never
  /// called.
  Heartbeat(std::chrono::milliseconds quiet, std::function<void()> say);
  /// Ends the thread; `say` is not called any more once the destructor returns.
  ~Heartbeat() = default;
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

  /// Starts the quiet time anew, because something else has been reported.
  void beat();

 private:
  void wait(const std::stop_token& stop);

  const std::chrono::milliseconds quiet_;
  const std::function<void()> say_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool beaten_ = false;
  std::jthread thread_;  // the last member, so that it ends before what it uses is destroyed
};

}  // namespace spindrift::app
