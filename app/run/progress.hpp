// How far a run is: a line that changes on a terminal, lines now and then where there is none, or a
// line of JSON for each frame.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "app/kept/run_options.hpp"
#include "app/scene/scene.hpp"
#include "app/system/heartbeat.hpp"

namespace spindrift::app {

/// The longest time for which a log is not told anything.
constexpr std::chrono::seconds longest_silence{30};

/// When a log is to be told how far something is: at the beginning, after each tenth, and after
/// the longest silence.
class LogPace {
 public:
  /// @param part that is done, 0 ... 1
  bool is_due(double part);

 private:
  double told_part_ = -1;
  std::chrono::steady_clock::time_point told_;
};

class Progress {
 public:
  /// @param frames in the whole run. @param particles at its start
  Progress(const Scene& scene, const RenderOptions& options, int frames, std::size_t particles);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Frame `number` has just been finished by `stage`, and is the run's `done`th; from one thread.
  void show(const char* stage, int number, int done);
  /// How many particles there are now; may be called from another thread than show().
  void set_particles(std::size_t particles) { particles_ = particles; }

 private:
  enum class Form { none, terminal, log, json };

  void show_on_terminal(const char* stage, int done, double seconds_left);
  void show_in_log();

  std::string scene_;
  int frames_;
  double frames_per_second_;
  std::atomic<std::size_t> particles_;
  Form form_;
  bool drawn_ = false;
  std::atomic<int> done_ = 0;
  LogPace pace_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_shown_{};
  std::optional<Heartbeat> heartbeat_;  ///< of a log; the last member, since it shows the others
};

/// "48 s", "3 min 05 s", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace spindrift::app
