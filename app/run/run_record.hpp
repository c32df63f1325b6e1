// What a run did.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/kept/simulation_record.hpp"
#include "app/run/probe_table.hpp"

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

}  // namespace spindrift::app
