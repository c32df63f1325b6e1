// Liquid that emitters bring. In the nozzle it moves as the emitter wants, whatever pushes it; it
// counts in its neighbours' densities, and its pressure pushes them, as that of a wall that moves
// along would. The first particles behind the opening then have all their neighbours.
#pragma once

#include <vector>

#include "sim/boundary/walls.hpp"
#include "sim/core/exchange.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/particles/particle_exchange.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// A layer of particles in a nozzle, as loops look at it.
struct HeldLayer {
  std::uint32_t first_id;
  std::uint32_t size;
  std::uint32_t nozzle;
  const glm::vec3* points;  ///< in the opening, m
  glm::vec3 direction;      ///< of unit length
  glm::vec3 velocity;       ///< m/s
  double way;               ///< from the opening, m; negative in the nozzle
  double fall;              ///< time since it left the nozzle, s; negative before that
};

/// Those that are in nozzles, by their first number.
struct HeldLayersView {
  const HeldLayer* layers;
  std::uint32_t count;

  /// That of a particle; null where it has none.
  SPINDRIFT_HD const HeldLayer* of(std::uint32_t id) const {
    if (count == 0 || id < layers[0].first_id)
      return nullptr;
    for (std::uint32_t k = 0; k < count; ++k)
      if (id >= layers[k].first_id && id - layers[k].first_id < layers[k].size)
        return layers + k;
    return nullptr;
  }
};

class Inflow {
 public:
  /// @param first_id the first number that no particle of the start has
  Inflow(const Settings& settings, const FluidConstants& constants, std::uint32_t first_id);

  bool exists() const { return !nozzles_.empty(); }
  const std::vector<Nozzle>& nozzles() const { return nozzles_; }
  /// Numbers given away until a time are below this one.
  std::uint32_t next_id(double time) const;
  /// When the next emitter begins after a time, at most `end`, s.
  double next_begin(double time, double end) const;
  /// The fastest speed in any nozzle in the time between, m/s.
  float speed_within(double begin, double end) const;

  /// Finds out which samples of walls and obstacles the nozzles open.
  void attach(Walls& walls);
  /// Goes on from a time at which all that had come in by then is there.
  void resume(Executor& executor, Particles& particles, Walls& walls, double time);

  /// Whether the last exchange brought particles close to others, or changed a wall at once.
  bool disturbs() const { return disturbs_; }
  /// 1 for each particle that is in a nozzle, 0 for others; null where none is.
  const float* held(const Particles& particles) const {
    return held_layers_.empty() ? nullptr : particles.held.data();
  }
  /// Puts them where they are at a time, as drifted.
  void carry(Executor& executor, Particles& particles, double time);

  /// At the end of a step: lets go what has left the nozzles, and brings what came into them.
  /// @param last_step    its length, s
  /// @param acceleration of the body, m/s²: what is let go has been falling since it was out
  /// @return what came
  Exchange advance(Executor& executor, Particles& particles, Walls& walls, double time,
                   double last_step, const Vec3<float>& acceleration);

  // Parts of advance(); public since CUDA has no loops in private functions.
  void release(Executor& executor, Particles& particles, double time, double last_step,
               const Vec3<float>& acceleration);
  /// Opens walls, and closes them again, as they are at the end of a step, s. A nozzle that begins
  /// there opens its wall when its liquid has come, with open_walls(end, end).
  void open_walls(Executor& executor, Walls& walls, double start, double end);
  /// Notes which particles are in a nozzle.
  void mark(Executor& executor, Particles& particles);
  /// Particles in a box, but for those in a nozzle, m.
  std::vector<glm::vec3> in_the_place_of(Executor& executor, Particles& particles,
                                         std::uint32_t nozzle, const Box& place);

  /// A wall's sample while all nozzles are closed, and what this one takes from it while it is
  /// open.
  struct WallSample {
    std::uint32_t index;
    float volume, solid;  ///< m³; as Boundary's
    float part, loss;     ///< of the volume that is left; of `solid`
  };

 private:
  struct Layer {
    std::uint32_t first_id;
    std::uint32_t nozzle;
    std::int64_t k;
  };
  struct Opening {
    Array<WallSample> samples;
    double closed_part = 1;
  };

  Layer layer(std::uint32_t nozzle, std::int64_t k) const;
  Exchange bring(Executor& executor, Particles& particles, const Layer& layer, double time);
  void note_held_layers(double time);
  /// Brings the layers to where loops find them, as they are at a time.
  HeldLayersView layers_at(double time);
  /// As they were brought last.
  HeldLayersView layers() const {
    return {layers_.data(), static_cast<std::uint32_t>(layers_.size())};
  }

  Settings settings_;
  FluidConstants constants_;
  std::uint32_t first_id_;
  std::vector<Nozzle> nozzles_;
  std::vector<std::int64_t> entered_;  ///< layers of each nozzle that have been brought
  std::vector<Layer> held_layers_;     ///< by their first number
  std::vector<Opening> openings_;      ///< of the nozzles, in walls
  bool disturbs_ = false;
  std::vector<Array<glm::vec3>> points_;  ///< in each nozzle's opening, m
  Array<HeldLayer> layers_;               ///< those of held_layers_
  Array<std::uint32_t> found_;            ///< particles in the place of others
  Array<Vec3<float>> found_positions_;    ///< m
  ParticleExchange exchange_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
