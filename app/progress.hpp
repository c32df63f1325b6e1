// A line on the terminal that says how far a run is; nothing where no person is looking.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace spindrift::app {

class Progress {
 public:
  /// @param frames in the whole run
  Progress(std::string scene, int frames, std::size_t particles, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Frame `done` of the run has just been finished by `stage`.
  void show(const char* stage, int done);
  /// How many particles there are now; may be called from another thread than show().
  void set_particles(std::size_t particles) { particles_ = particles; }
  /// Takes the line away.
  void clear();

 private:
  std::string scene_;
  int frames_;
  std::atomic<std::size_t> particles_;
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_shown_{};
};

/// "48 s", "3 min 05 s", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace spindrift::app
