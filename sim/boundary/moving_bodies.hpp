// Obstacles that move, as boundary samples among those of the walls: where they are during a step,
// and what they do to the liquid.
//
// A body that moves keeps its volumes and its `solid` (sim/boundary/boundary.hpp), found for it
// alone. Where two solids overlap, as a piston and the walls it runs along, each would add its own
// layer of samples, and the liquid would be too dense there; so a sample that lies deeper in
// another solid than that one's own layer, half a spacing, is left out. Of two layers at the same
// place, that of the body which moves stays, and of two such the later one's. Where two layers meet
// at an angle, samples of both that are closer than a spacing share the place: V_b / (1 + Σ max(0,
// 1 − r/d)).
#pragma once

#include <vector>

#include "sim/backend/backend.hpp"
#include "sim/boundary/boundary.hpp"
#include "sim/boundary/posed_body.hpp"
#include "sim/particles/formulas.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// What is solid, as loops over samples look at it.
struct SolidsView {
  static constexpr int fixed = -1;  ///< as the owner of a sample
  const PosedBody* bodies;
  int body_count;
  const Solid* solids;  ///< that are fixed
  const Box* bounds;    ///< of those, m
  int solid_count;
  Inside domain;
  float spacing;  ///< m

  /// Whether another solid's layer of samples lies between a sample and the liquid.
  SPINDRIFT_HD bool is_covered(const Vec3<float>& p, int owner) const;

  /// False where no solid that moves relative to the sample's own can have samples within a
  /// spacing.
  SPINDRIFT_HD bool may_meet_another(const Vec3<float>& p, int owner) const;
};

class MovingBodies {
 public:
  /// @param boundary the samples of what is fixed; this object puts the others among them
  /// @param meshes   where loops find meshes
  MovingBodies(const Settings& settings, const GridMap& map, Boundary& boundary, Meshes& meshes,
               Stop stop);

  /// The samples of all solids, where the scene puts them; those of what is fixed first, as they
  /// were in the boundary that this object was made with.
  Boundary::Sample* samples() { return samples_.data(); }

  /// Puts the samples where the bodies are at the end of a step, s.
  void place(Executor& executor, double start, double end);

  /// The bodies as they were placed.
  const Array<PosedBody>& bodies() const { return bodies_; }

  /// The longest step of at most `longest` (s) from a time on in which no point of a body goes
  /// farther than `distance`, m.
  double step_within(double distance, double time, double longest) const;

  /// Pressures of all samples, in an order that does not depend on where they are, Pa.
  Copy<float> pressures(Executor& executor);
  std::size_t sample_count() const { return samples_.size(); }
  void set_pressures(const std::vector<float>& pressures);

  std::size_t memory_bytes() const;

  // Parts of place(); public since CUDA has no loops in private functions.
  void keep_pressures(Executor& executor);
  void share_places(Executor& executor, const SolidsView& solids);

 private:
  static constexpr int fixed = SolidsView::fixed;
  void add(const Obstacle& obstacle, int body, std::vector<Boundary::Sample>& samples,
           std::vector<int>& owners, Stop stop) const;

  Settings settings_;
  GridMap map_;
  Boundary& boundary_;
  std::vector<Solid> all_solids_;  ///< of the scene's obstacles, in their order
  Array<Solid> fixed_solids_;
  Array<Box> fixed_bounds_;
  Array<PosedBody> bodies_;
  Array<Boundary::Sample> samples_;  ///< of all solids, where the scene puts them
  Array<Boundary::Sample> here_;     ///< where they are
  Array<int> owners_;                ///< per sample: the scene's number of a body, or `fixed`
  Array<std::uint8_t> covered_;      ///< per sample
  Array<std::uint32_t> open_;        ///< numbers of the samples that are not covered
  Array<std::uint32_t> placed_;      ///< the same, as they are sorted in the boundary
};

/// Work of the moving bodies on the liquid in a step of length `time_step` (s), J: pressure and
/// friction of each sample on the liquid times the way that the sample goes,
///   F_b = −V V_b Σᵢ (pᵢ + p_b) ∇W + 2 μ_b V_b Σᵢ w (v_b − vᵢ).
double wall_work(Executor& executor, const FluidConstants& constants, PressureKernel kernel,
                 Particles& particles, const BoundaryView& boundary, float time_step);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
