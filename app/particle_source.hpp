// Where a run's particles come from: the cache as far as it goes, then the simulation.
#pragma once

#include <memory>
#include <optional>

#include "app/particle_cache.hpp"
#include "app/pipeline.hpp"

namespace spindrift::app {

class ParticleSource {
 public:
  /// @throws std::runtime_error or SceneError when the folder of --from-particles does not fit the
  /// scene
  ParticleSource(const Scene& scene, const RenderOptions& options);
  ~ParticleSource();

  std::size_t particle_count() const { return particle_count_; }

  /// Frame `number`, asked for in order from 0; nothing after Ctrl-C.
  std::optional<KeptFrame> next(int number);

  /// Leaves in the record what was simulated.
  void finish(RunRecord& record) const;

 private:
  KeptFrame simulate(int number);

  const Scene& scene_;
  std::optional<ParticleCache> cache_;
  bool read_only_ = false;  ///< particles are given, never simulated
  bool cached_so_far_ = true;
  KeptFrame last_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::size_t particle_count_ = 0;
  int simulated_ = 0;
};

}  // namespace spindrift::app
