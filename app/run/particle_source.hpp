// Where a run's particles come from: the cache as far as it goes, then the simulation. The scene's
// probes are read on the way.
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "app/kept/particle_cache.hpp"
#include "app/kept/run_options.hpp"
#include "app/run/run_record.hpp"

namespace spindrift::app {

/// A frame on its way to whoever wants it, and what happened until then.
struct ComingFrame {
  std::future<sim::Frame> frame;
  sim::FrameStatistics statistics;
  double time = 0;  ///< s
  std::size_t particle_count = 0;
  bool kept = false;  ///< it came from the cache
};

class ParticleSource {
 public:
  /// @param readings what the scene's probes read, added to as frames are asked for
  /// @throws std::runtime_error when the folder of --from-particles has no first frame
  ParticleSource(const Scene& scene, const RenderOptions& options,
                 std::vector<ProbeReading>& readings);
  ~ParticleSource();

  /// The most that there were at once so far.
  std::size_t particle_count() const { return particle_count_; }

  /// Frame `number`, asked for in order from 0; nothing after Ctrl-C.
  std::optional<ComingFrame> next(int number);

  /// Waits for the frame, and keeps it, if it is not; from any thread, also while the next one is
  /// asked for.
  KeptFrame keep(int number, ComingFrame coming) const;

  /// Leaves in the record what was simulated.
  void finish(RunRecord& record) const;

 private:
  ComingFrame kept(int number, KeptFrame frame);
  SimulationRecord record() const;
  bool start_simulation(int number);
  std::optional<ComingFrame> simulate(int number);
  void keep_readings(int number, std::size_t first) const;
  bool add_kept_readings(int number);
  double time_of(int number) const;
  std::vector<double> readings_due(int number) const;
  std::vector<double>::const_iterator read_probes(const sim::Frame& frame,
                                                  std::vector<double>::const_iterator due,
                                                  std::vector<double>::const_iterator end);

  const Scene& scene_;
  std::vector<ProbeReading>& readings_;
  std::optional<ParticleCache> cache_;
  ProbeReading at_last_stop_;  ///< of the simulation at work
  std::string readings_name_;  ///< of the files that readings between frames are kept in
  bool read_only_ = false;     ///< particles are given, never simulated
  sim::Frame last_;            ///< that a simulation goes on from, where none is at work
  std::unique_ptr<sim::Simulation> simulation_;
  SimulationRecord earlier_;  ///< of all but `simulation_`
  std::size_t particle_count_ = 0;
  int simulated_ = 0;
  int read_once_ = 0;  ///< frames whose readings in between were not kept
};

}  // namespace spindrift::app
