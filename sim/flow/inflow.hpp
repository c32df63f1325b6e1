// The liquid that emitters bring. In its nozzle it moves as the emitter prescribes, whatever pushes
// it; it counts in its neighbours' densities, and its pressure pushes them, as that of a wall
// moving along would. So the first particles beyond the opening have all their neighbours.
#pragma once

#include <vector>

#include "sim/boundary/walls.hpp"
#include "sim/core/exchange.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/particles/particle_exchange.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// A layer of particles that a nozzle carries, as plain data that loops can read.
struct HeldLayer {
  std::uint32_t first_id;   ///< its particles have the ids first_id … first_id + size − 1
  std::uint32_t size;       ///< number of particles, with those that were held back
  std::uint32_t nozzle;     ///< index of the nozzle
  const glm::vec3* points;  ///< of its particles in the opening, m
  glm::vec3 direction;      ///< of unit length
  glm::vec3 velocity;       ///< m/s
  double way;               ///< distance from the opening, m; negative in the nozzle
  double fall;              ///< time since it left the nozzle, s; negative before that
};

/// All layers that nozzles carry, in ascending order of their first ids.
struct HeldLayersView {
  const HeldLayer* layers;
  std::uint32_t count;

  /// The layer of the particle with this id; null if no nozzle carries it.
  SPINDRIFT_HD const HeldLayer* of(std::uint32_t id) const {
    if (count == 0 || id < layers[0].first_id)
      return nullptr;
    for (std::uint32_t k = 0; k < count; ++k)
      if (id >= layers[k].first_id && id - layers[k].first_id < layers[k].size)
        return layers + k;
    return nullptr;
  }
};

/// A boundary particle as it is while all nozzles are closed, and what one nozzle takes from it
/// while that is open.
struct WallSample {
  std::uint32_t index;
  float volume, solid;  ///< Boundary::volume(), m³; Boundary::solids()
  float part, loss;     ///< the fraction of the volume that it keeps; what is taken off `solid`
};

/// All emitters of a run.
class Inflow {
 public:
  /// @param first_id the lowest id that no initial particle has
  Inflow(const Settings& settings, const FluidConstants& constants, std::uint32_t first_id);

  bool exists() const { return !nozzles_.empty(); }
  /// The lowest id that is not given to any particle up to a time, s.
  /// @throws std::runtime_error if the ids run out
  std::uint32_t next_id(double time) const;
  /// The time at which the next emitter begins after a time, at most `end`, s.
  double next_begin(double time, double end) const;
  /// The highest speed in any nozzle between two times (s), m/s.
  float speed_within(double begin, double end) const;

  /// Finds the boundary particles that each nozzle takes away or lessens while it is open.
  void attach(Walls& walls);
  /// Goes on from a time (s), with `particles` containing all that had come in by then.
  void resume(Executor& executor, Particles& particles, Walls& walls, double time);

  /// Whether the last advance() brought particles close to others, or opened a wall at once.
  bool disturbs() const { return disturbs_; }
  /// 1 for each particle that a nozzle carries, 0 for others; null if none is carried.
  const float* held(const Particles& particles) const {
    return held_layers_.empty() ? nullptr : particles.held.data();
  }
  /// Sets the drifted positions and velocities of the carried particles to those at a time, s.
  void carry(Executor& executor, Particles& particles, double time);

  /// At the end of a step, releases the particles that have left the nozzles, adds those that have
  /// entered them, and opens and closes walls.
  /// @param time at the end of the step, s
  /// @param last_step size of the step, s
  /// @param acceleration by body forces, m/s², with which particles fall from the opening on
  /// @return what came in
  /// @throws std::runtime_error if the ids run out
  Exchange advance(Executor& executor, Particles& particles, Walls& walls, double time,
                   double last_step, const Vec3<float>& acceleration);

  std::size_t memory_bytes() const {
    std::size_t sum = bytes_of(openings_, layers_, found_, found_positions_, exchange_);
    for (const Array<glm::vec3>& points : points_)
      sum += bytes_of(points);
    return sum;
  }

  /// Sets the boundary particles at the nozzles to how far each is closed at the end of a step,
  /// both times in s. A nozzle that begins there opens its wall only when its liquid has come, in
  /// advance().
  void open_walls(Executor& executor, Walls& walls, double start, double end);

 private:
  struct Layer {
    std::uint32_t first_id;  ///< the lowest id of its particles
    std::uint32_t nozzle;    ///< index of the nozzle
    std::int64_t k;          ///< number of the layer in its nozzle
  };
  /// What one nozzle opens in walls and obstacles.
  struct Opening {
    Array<WallSample> samples;
    double closed_part = 1;  ///< Nozzle::closed_part() as last applied
    std::size_t memory_bytes() const { return bytes_of(samples); }
  };

  Layer layer(std::uint32_t nozzle, std::int64_t k) const;
  /// Adds the particles of a layer, except where other liquid is in their place.
  Exchange bring(Executor& executor, Particles& particles, const Layer& layer, double time);
  /// Updates the list of layers that nozzles carry at a time, s.
  void note_held_layers(double time);
  /// Copies the carried layers, as they are at a time (s), to where loops find them.
  HeldLayersView layers_at(double time);
  /// The carried layers as layers_at() has last copied them.
  HeldLayersView layers() const {
    return {layers_.data(), static_cast<std::uint32_t>(layers_.size())};
  }

  Settings settings_;
  FluidConstants constants_;
  std::uint32_t first_id_;
  std::vector<Nozzle> nozzles_;
  std::vector<std::int64_t> entered_;  ///< per nozzle: number of layers that have been brought
  std::vector<Layer> held_layers_;     ///< carried by nozzles, in ascending order of first_id
  std::vector<Opening> openings_;      ///< per nozzle
  bool disturbs_ = false;
  std::vector<Array<glm::vec3>> points_;  ///< per nozzle: Nozzle::points(), m
  Array<HeldLayer> layers_;               ///< held_layers_ for loops
  Array<std::uint32_t> found_;            ///< indices of particles that in_the_place_of() found
  Array<Vec3<float>> found_positions_;    ///< their positions, m
  ParticleExchange exchange_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
