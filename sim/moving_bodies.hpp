// Obstacles that move, as boundary samples among those of the walls: where they are during a step,
// and what they do to the liquid.
//
// A body that moves keeps its volumes and its `solid` (sim/boundary.hpp), found for it alone. Where
// two solids overlap, as a piston and the walls it runs along, each would add its own layer of
// samples, and the liquid would be too dense there; so a sample that lies deeper in another solid
// than that one's own layer, half a spacing, is left out. Of two layers at the same place, that of
// the body which moves stays, and of two such the later one's. Where two layers meet at an angle,
// samples of both that are closer than a spacing share the place: V_b / (1 + Σ max(0, 1 − r/d)).
#pragma once

#include <vector>

#include "sim/backend.hpp"
#include "sim/boundary.hpp"
#include "sim/formulas.hpp"
#include "sim/posed_body.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class MovingBodies {
 public:
  /// @param boundary the samples of what is fixed; this object puts the others among them
  MovingBodies(const Settings& settings, const GridMap& map, Boundary& boundary);

  /// Changes how much a sample of what is fixed stands for, from the next time on that samples are
  /// put where they are. @param b its number in the boundary that this object was made with
  void set_sample(std::uint32_t b, float volume, float solid) {
    samples_[b].volume = volume;
    samples_[b].solid = solid;
  }

  /// Puts the samples where the bodies are at the end of a step, s.
  void place(Executor& executor, double start, double end);

  /// The bodies as they were placed.
  const std::vector<PosedBody>& bodies() const { return bodies_; }

  /// The longest step of at most `longest` (s) from a time on in which no point of a body goes
  /// farther than `distance`, m.
  double step_within(double distance, double time, double longest) const;

  /// Pressures of all samples, in an order that does not depend on where they are, Pa.
  std::vector<float> pressures() const;
  void set_pressures(const std::vector<float>& pressures);

  std::size_t memory_bytes() const;

 private:
  /// The scene's number of a body, or `fixed`.
  static constexpr int fixed = -1;
  void add(const Obstacle& obstacle, int body);
  bool is_covered(const Vec3<float>& p, int owner) const;
  bool may_meet_another(std::size_t sample, const Vec3<float>& p) const;
  void share_places();
  void keep_pressures();

  Settings settings_;
  Inside domain_;
  GridMap map_;
  Boundary& boundary_;
  std::vector<PosedBody> bodies_;
  std::vector<Boundary::Sample> samples_;  ///< of all solids, where the scene puts them
  std::vector<int> owners_;                ///< per sample
  std::vector<std::uint32_t> placed_;      ///< numbers of the samples that are in the boundary
};

/// Work of the moving bodies on the liquid in a step of length `time_step` (s), J: pressure and
/// friction of each sample on the liquid times the way that the sample goes,
///   F_b = −V V_b Σᵢ (pᵢ + p_b) ∇W + 2 μ_b V_b Σᵢ w (v_b − vᵢ).
double wall_work(Executor& executor, const FluidConstants& constants, PressureKernel kernel,
                 Particles& particles, const BoundaryView& boundary, float time_step);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
