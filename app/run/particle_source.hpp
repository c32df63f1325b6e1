// Supplies the frames of particles of a run: from the particle cache as far as it goes, and from
// the simulation after that. The scene's probes are read on the way.
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "app/cache/particle_cache.hpp"
#include "app/resources/run_options.hpp"
#include "app/run/run_record.hpp"

namespace spindrift::app {

/// A frame that may still be on its way from the simulation, and the statistics of the time steps
/// that led to it.
struct ComingFrame {
  std::future<sim::Frame> frame;
  sim::FrameStatistics statistics;
  double time = 0;  ///< s
  std::size_t particle_count = 0;
  bool cached = false;  ///< whether it was read from a file
};

/// The frames of one run, one after the other.
class ParticleSource {
 public:
  /// @param scene, options must outlive this object
  /// @param readings receives the readings of the scene's probes up to the frame last asked for;
  /// must outlive this object
  /// @throws std::runtime_error where the folder of --from-particles has no first frame
  ParticleSource(const Scene& scene, const RenderOptions& options,
                 std::vector<ProbeReading>& readings);
  ~ParticleSource();

  /// The largest number of particles in a frame so far; before the first frame, that of the start.
  std::size_t particle_count() const { return particle_count_; }

  /// Reads or simulates a frame. Frames must be asked for in order, from number 0.
  /// @return nothing after Ctrl-C
  /// @throws std::runtime_error where the folder of --from-particles lacks the frame, or no
  /// admissible time step exists
  std::optional<ComingFrame> next(int number);

  /// Waits for a frame, and writes it to the cache unless it came from there. It may be called from
  /// any thread, also while next() is at work on a later frame.
  CachedFrame keep(int number, ComingFrame coming) const;

  /// Writes into the record how many frames were simulated, and how the particles came about.
  void finish(RunRecord& record) const;

 private:
  ComingFrame cached(int number, CachedFrame frame);
  SimulationRecord record() const;
  bool start_simulation(int number);
  std::optional<ComingFrame> simulate(int number);
  void keep_readings(int number, std::size_t first) const;
  bool add_cached_readings(int number);
  double time_of(int number) const;
  std::vector<double> readings_due(int number) const;
  std::vector<double>::const_iterator read_probes(const sim::Frame& frame,
                                                  std::vector<double>::const_iterator due,
                                                  std::vector<double>::const_iterator end);

  const Scene& scene_;
  std::vector<ProbeReading>& readings_;
  std::optional<ParticleCache> cache_;
  ProbeReading at_last_stop_;  ///< probes at the last stop of `simulation_`
  /// Name of the cache's files with readings between frames; empty where there are none.
  std::string readings_name_;
  bool read_only_ = false;  ///< whether the particles are those of --from-particles
  sim::Frame last_;         ///< last frame read, from which a simulation would go on
  std::unique_ptr<sim::Simulation> simulation_;  ///< none while frames are read
  SimulationRecord earlier_;  ///< how frames came about, but for the figures of `simulation_`
  std::size_t particle_count_ = 0;
  int simulated_ = 0;
  int read_once_ = 0;  ///< number of cached frames without the readings before them
};

}  // namespace spindrift::app
