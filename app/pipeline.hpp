// From particles to files: simulate → keep → mesh → draw → write, in four threads, so that the next
// frame is simulated while the last one is kept, drawn and written.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/particle_cache.hpp"
#include "app/probe_table.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {

/// What a run did, for reports.
struct RunRecord {
  std::size_t particles = 0;    ///< the most at once
  SimulationRecord simulation;  ///< how they came about, in this run or before
  int first_frame = 0;
  int frames_wanted = 0;
  int frames_simulated = 0;  ///< the rest came from the cache
  int frames_read_once = 0;  ///< whose probes should have been read more often
  int frames_finished = 0;   ///< drawn and written, or simulated where nothing is drawn
  bool interrupted = false;
  double wall_seconds = 0;
  std::map<std::string, double> stage_seconds;  ///< wall time in each stage; stages overlap
  std::vector<sim::FrameStatistics> frames;  ///< one for each frame from 0 to the last one reached
  std::vector<double> times;                 ///< of those frames, s
  std::vector<ProbeReading> probe_readings;  ///< in the order of their times
  std::filesystem::path video;               ///< that was written; empty: none
  std::string gl_renderer, gl_version, egl_device;  ///< empty: nothing was drawn
};

/// Runs the scene as the options say. What is finished when an error or Ctrl-C comes stays, and the
/// video is closed so that it plays. @throws what the failing stage threw
void run_pipeline(const Scene& scene, const RenderOptions& options, RunRecord& record);

}  // namespace spindrift::app
