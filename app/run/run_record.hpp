// The record of what a run did. The stages of a run fill it, and reports are made of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/cache/simulation_record.hpp"
#include "app/run/probe_table.hpp"

namespace spindrift::app {

/// What a run did, and how long it took.
struct RunRecord {
  std::size_t particles = 0;    ///< largest number at once
  SimulationRecord simulation;  ///< how the particles came about, in this run or before
  int first_frame = 0;
  int frames_wanted = 0;
  int frames_simulated = 0;  ///< the rest came from the cache
  int frames_read_once = 0;  ///< cached frames without the readings before them
  int frames_finished = 0;   ///< drawn and written, or simulated where nothing is drawn
  bool interrupted = false;  ///< whether Ctrl-C ended it before its last frame
  double wall_seconds = 0;   ///< wall-clock time of the run
  std::map<std::string, double> stage_seconds;  ///< wall-clock time of each stage; stages overlap
  std::vector<sim::FrameStatistics> frames;     ///< one per frame from 0 to the last one reached
  std::vector<double> times;                    ///< times of those frames, s
  std::vector<ProbeReading> probe_readings;     ///< in the order of their times
  std::filesystem::path video;                  ///< video that was written; empty: none
  std::string gl_renderer, gl_version, egl_device;  ///< empty: nothing was drawn
};

}  // namespace spindrift::app
