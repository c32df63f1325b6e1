// Reports on standard error how far a run is: by a line that is rewritten on a terminal, by lines
// now and then where there is none, or by a line of JSON for each frame.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "app/resources/run_options.hpp"
#include "app/scene/scene.hpp"
#include "app/system/heartbeat.hpp"

namespace spindrift::app {

/// The longest time that passes between two lines of a log.
constexpr std::chrono::seconds longest_silence{30};

/// Decides when a log gets a line on how far something is: at the beginning, after each tenth, and
/// after the longest silence.
class LogPace {
 public:
  /// Whether a line is due; if so, it is taken to be written now.
  /// @param part the finished part, 0 ... 1
  bool is_due(double part);

 private:
  double told_part_ = -1;  ///< finished part at the last line; -1: there was no line yet
  std::chrono::steady_clock::time_point told_;  ///< time of the last line
};

/// The progress report of one run.
class Progress {
 public:
  /// @param frames the number of frames that the run is to finish
  /// @param particles the number of particles at its start
  Progress(const Scene& scene, const RenderOptions& options, int frames, std::size_t particles);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `stage` has finished frame `number`, which is the `done`th frame finished. It
  /// must always be called from the same thread.
  void show(const char* stage, int number, int done);
  /// Sets the number of particles that is reported; may be called from another thread than show().
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
  std::optional<Heartbeat> heartbeat_;  ///< for a log; the last member, since it reads the others
};

/// A duration as "48 s", "3 min 05 s" or "2 h 10 min".
/// @param seconds rounded up to whole seconds
std::string duration_text(double seconds);

}  // namespace spindrift::app
