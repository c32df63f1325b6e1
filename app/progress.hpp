// How far a run is: a line that changes on a terminal, lines now and then where there is none, or a
// line of JSON for each frame.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "app/commands.hpp"

namespace spindrift::app {

/// When a log is to be told how far something is: at the beginning, after each tenth, and after
/// half a minute without a word.
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

  std::string scene_;
  int frames_;
  double frames_per_second_;
  std::atomic<std::size_t> particles_;
  Form form_;
  bool drawn_ = false;
  LogPace pace_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_shown_{};
};

/// "48 s", "3 min 05 s", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace spindrift::app
