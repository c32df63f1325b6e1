// The boundary particles of obstacles that move: where they are during a step, which of them count,
// and the work that they do on the liquid.
//
// A moving body keeps its volumes and its `solid` (sim/boundary/boundary.hpp), which are computed
// for it alone. Where two solids overlap, as a piston and the walls that it runs along, each would
// add its own layer of boundary particles, and the liquid would be too dense there. So a boundary
// particle that lies deeper in another solid than that one's own layer, half a spacing, is left
// out. Of two layers at the same place, that of the moving body stays, and if both move, that of
// the later one. Where two layers meet at an angle, boundary particles of both that are closer than
// a spacing share the volume: V_b / (1 + Σ max(0, 1 − r/d)).
#pragma once

#include <vector>

#include "sim/backend/backend.hpp"
#include "sim/boundary/boundary.hpp"
#include "sim/boundary/posed_body.hpp"
#include "sim/particles/formulas.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// All solids, as plain data that loops over boundary particles can capture.
struct SolidsView {
  static constexpr int fixed = -1;  ///< the owner of a boundary particle of what does not move
  const PosedBody* bodies;          ///< the moving obstacles
  int body_count;
  const Solid* solids;  ///< the fixed obstacles
  const Box* bounds;    ///< the bounding boxes of `solids`, m
  int solid_count;
  Inside domain;
  float spacing;  ///< of the particles, m

  /// Whether another solid's layer of boundary particles lies between a boundary particle and the
  /// liquid.
  /// @param p the boundary particle's position, m
  /// @param owner the index of its body, or `fixed`
  SPINDRIFT_HD bool is_covered(const Vec3<float>& p, int owner) const;

  /// Whether a solid that moves relative to the owner may have boundary particles within a spacing
  /// of p; false is certain, true is not.
  SPINDRIFT_HD bool may_meet_another(const Vec3<float>& p, int owner) const;
};

/// The moving obstacles of a run. Before each step it places their boundary particles among the
/// fixed ones of a Boundary.
class MovingBodies {
 public:
  /// @param boundary the boundary particles of what is fixed; this object adds the others to them
  /// @param meshes the meshes where loops find them
  /// @throws Stopped
  MovingBodies(const Settings& settings, const GridMap& map, Boundary& boundary, Meshes& meshes,
               Stop stop);

  /// The boundary particles of all solids, where the scene places them; first those of what is
  /// fixed, in the order of the boundary that this object was made with.
  Boundary::Sample* samples() { return samples_.data(); }

  /// Moves the bodies and their boundary particles to where they are at the end of a step from
  /// `start` to `end`, s.
  void place(Executor& executor, double start, double end);

  /// The moving bodies as they were last placed.
  const Array<PosedBody>& bodies() const { return bodies_; }

  /// The longest time step from a time (s) on, at most `longest` (s), in which no point of a body
  /// moves farther than `distance`, m.
  double step_within(double distance, double time, double longest) const;

  /// The pressures of all boundary particles, Pa, in the order of samples().
  Copy<float> pressures(Executor& executor);
  std::size_t sample_count() const { return samples_.size(); }
  /// Sets the pressures of all boundary particles, Pa, in the order of samples().
  void set_pressures(const std::vector<float>& pressures);

  std::size_t memory_bytes() const;

 private:
  static constexpr int fixed = SolidsView::fixed;
  void add(const Obstacle& obstacle, int body, std::vector<Boundary::Sample>& all,
           std::vector<int>& owners, Stop stop) const;

  Settings settings_;
  GridMap map_;
  Boundary& boundary_;
  std::vector<Solid> all_solids_;  ///< of the scene's obstacles, in their order
  Array<Solid> fixed_solids_;
  Array<Box> fixed_bounds_;
  Array<PosedBody> bodies_;
  Array<Boundary::Sample> samples_;  ///< of all solids, where the scene places them
  Array<Boundary::Sample> here_;     ///< the same where they are at the end of the step
  Array<int> owners_;                ///< per sample: index into bodies_, or `fixed`
  Array<std::uint8_t> covered_;      ///< per sample: 1 if it is left out
  Array<std::uint32_t> open_;        ///< indices of the samples that are not left out
  Array<std::uint32_t> placed_;      ///< the same in the order of the boundary
};

/// The work of the moving bodies on the liquid in a step of size `time_step` (s), J: the force of
/// each boundary particle on the liquid by pressure and friction times the particle's displacement,
///   F_b = −V V_b Σᵢ (pᵢ + p_b) ∇W + 2 μ_b V_b Σᵢ w (v_b − vᵢ).
double wall_work(Executor& executor, const FluidConstants& constants, PressureKernel kernel,
                 Particles& particles, const BoundaryView& boundary, float time_step);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
