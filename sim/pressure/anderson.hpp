// Anderson acceleration of a fixed-point iteration (Anderson 1965; Walker & Ni 2011, "Anderson
// acceleration for fixed-point iterations", eq. 1.3), with the last two steps as its memory. The
// PCISPH pressure iteration uses it.
//
// From the iterates pₖ and their residuals rₖ it takes the combination of the last three that makes
// the residual smallest,
//   p̄ = pₖ − θ₁ (pₖ − pₖ₋₁) − θ₂ (pₖ₋₁ − pₖ₋₂),   r̄ the same of r,   θ = argmin |r̄|²,
// and the next step starts from there.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/backend/backend.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The iterate of one unknown and its residual.
struct AndersonPoint {
  float iterate, residual;
};

/// The weights of the two earlier steps in the best combination with the present one. They live in
/// memory that the loops share (Kept).
struct AndersonWeights {
  int known = 0;               ///< number of earlier steps in memory
  int used = 0;                ///< number of those in the combination
  float last = 0, before = 0;  ///< the weights θ₁ and θ₂
  double squared = 0;          ///< |rₖ|²

  /// Sums over all unknowns of the products of the residual r, its change l since the last step,
  /// and its change b in the last step.
  struct Products {
    double rr = 0, lr = 0, ll = 0, br = 0, bl = 0, bb = 0;
    SPINDRIFT_HD static Products of(double r, double l, double b) {
      return {r * r, l * r, l * l, b * r, b * l, b * b};
    }
    SPINDRIFT_HD void join(const Products& o) {
      rr += o.rr;
      lr += o.lr;
      ll += o.ll;
      br += o.br;
      bl += o.bl;
      bb += o.bb;
    }
  };

  /// Finds the weights from the sums over all unknowns.
  SPINDRIFT_HD void find(const Products& s) {
    // A residual that grew has left the region in which earlier steps say anything: they are
    // forgotten.
    constexpr double growth = 1.5;
    if (known > 0 && s.rr > growth * growth * squared)
      known = 0;
    squared = s.rr;
    used = known;
    known = std::min(known + 1, 2);
    last = before = 0;
    const double determinant = s.ll * s.bb - s.bl * s.bl;
    if (used == 2 && determinant > 1e-6 * s.ll * s.bb) {
      last = bounded((s.lr * s.bb - s.bl * s.br) / determinant);
      before = bounded((s.ll * s.br - s.bl * s.lr) / determinant);
    } else if (used >= 1 && s.ll > 0) {
      last = bounded(s.lr / s.ll);
    }
  }

 private:
  SPINDRIFT_HD static float bounded(double w) {
    return static_cast<float>(std::clamp(w, -10., 10.));
  }
};

/// The two earlier steps and their weights, as loops see them.
struct AndersonView {
  const AndersonPoint* last;
  AndersonPoint* before;
  Kept<AndersonWeights>::View weights;

  /// The best combination for unknown i. @param now its present step
  SPINDRIFT_HD AndersonPoint mixed(std::uint32_t i, const AndersonPoint& now) const {
    return {mixed(i, now, &AndersonPoint::iterate), mixed(i, now, &AndersonPoint::residual)};
  }

  /// Remembers the present step of unknown i in place of the one before the last. To be called once
  /// for each unknown, after mixed().
  SPINDRIFT_HD void keep(std::uint32_t i, const AndersonPoint& now) const { before[i] = now; }

 private:
  SPINDRIFT_HD float mixed(std::uint32_t i, const AndersonPoint& now,
                           float AndersonPoint::*part) const {
    float value = now.*part;
    if (weights->used >= 1)
      value -= weights->last * (now.*part - last[i].*part);
    if (weights->used >= 2)
      value -= weights->before * (last[i].*part - before[i].*part);
    return value;
  }
};

/// The memory of the acceleration: start(), then combine() and advance() in every iteration.
class AndersonAcceleration {
 public:
  /// Forgets all earlier steps.
  void start() { knows_any_ = false; }

  /// Finds the best combination of the present step with the earlier ones.
  /// @param count number of unknowns
  /// @param now   now(i) is the AndersonPoint of unknown i in the present step
  template <class F>
  AndersonView combine(Executor& executor, std::uint32_t count, F now) {
    for (Array<AndersonPoint>* step : {&last_, &before_})
      resize_with_room(*step, count);
    const AndersonPoint *last_step = last_.data(), *step_before = before_.data();
    const bool knows_any = knows_any_;
    const auto so_far = weights_.view();
    const auto products = [=] SPINDRIFT_HD(std::uint32_t i) {
      const int known = knows_any ? so_far->known : 0;
      const float r = now(i).residual, r1 = last_step[i].residual;
      const float last = known >= 1 ? r - r1 : 0.f;
      const float before = known >= 2 ? r1 - step_before[i].residual : 0.f;
      return AndersonWeights::Products::of(r, last, before);
    };
    const auto find = [=] SPINDRIFT_HD(AndersonWeights & weights,
                                       const AndersonWeights::Products& sums) {
      if (!knows_any)
        weights = {};
      weights.find(sums);
    };
    executor.reduce_to<AndersonWeights::Products>("accelerate", count, weights_, products, find);
    knows_any_ = true;
    return {last_.data(), before_.data(), weights_.view()};
  }

  /// Makes the present step the last one, after AndersonView::keep() for every unknown.
  void advance() { last_.swap(before_); }

  std::size_t memory_bytes() const { return bytes_of(last_, before_); }

 private:
  Array<AndersonPoint> last_, before_;
  Kept<AndersonWeights> weights_;
  bool knows_any_ = false;  ///< whether there is any earlier step
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
