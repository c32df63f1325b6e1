#include "app/system/heartbeat.hpp"

#include <system_error>
#include <utility>

namespace spindrift::app {

Heartbeat::Heartbeat(std::chrono::milliseconds quiet, std::function<void()> say)
    : quiet_(quiet), say_(std::move(say)) {
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { wait(stop); });
  } catch (const std::system_error&) {
    // Whatever needs threads reports that none can be started.
  }
}

void Heartbeat::beat() {
  {
    const std::lock_guard lock(mutex_);
    beaten_ = true;
  }
  changed_.notify_one();
}

void Heartbeat::wait(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    if (!changed_.wait_for(lock, stop, quiet_, [this] { return beaten_; }) &&
        !stop.stop_requested())
      say_();
    beaten_ = false;
  }
}

}  // namespace spindrift::app
