// A sign of life while something takes long.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace spindrift::app {

class Heartbeat {
 public:
  /// Calls `say`, in a thread of its own, whenever beat() has not been called for so long, and
  /// again after as long. Where there is no thread to be had it says nothing.
  Heartbeat(std::chrono::milliseconds quiet, std::function<void()> say);
  /// `say` is not called any more once this returns.
  ~Heartbeat() = default;
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

  /// Something else has been said.
  void beat();

 private:
  void wait(const std::stop_token& stop);

  const std::chrono::milliseconds quiet_;
  const std::function<void()> say_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool beaten_ = false;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace spindrift::app
