// Anderson acceleration of a fixed-point iteration (Anderson 1965; Walker & Ni 2011, "Anderson
// acceleration for fixed-point iterations", eq. 1.3), with the last two steps as its memory.
//
// From the iterates pₖ and their residuals rₖ it takes the combination of the last three that makes
// the residual smallest,
//   p̄ = pₖ − θ₁ (pₖ − pₖ₋₁) − θ₂ (pₖ₋₁ − pₖ₋₂),   r̄ the same of r,   θ = argmin |r̄|²,
// and the next step starts from there.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/backend.hpp"
#include "sim/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// An unknown, and how wrong it is.
struct AndersonPoint {
  float iterate, residual;
};

/// The two steps before, and what of them goes into the best combination with the present one.
struct AndersonView {
  const AndersonPoint* last;
  AndersonPoint* before;
  int used;                          ///< earlier steps in the combination
  float last_weight, before_weight;  ///< θ₁ and θ₂

  /// The best combination for unknown i, of which `now` is the present step.
  SPINDRIFT_HD AndersonPoint mixed(std::uint32_t i, const AndersonPoint& now) const {
    return {mixed(i, now, &AndersonPoint::iterate), mixed(i, now, &AndersonPoint::residual)};
  }

  /// Remembers the present step in place of the one before the last. Once for each unknown, after
  /// it is mixed.
  SPINDRIFT_HD void keep(std::uint32_t i, const AndersonPoint& now) const { before[i] = now; }

 private:
  SPINDRIFT_HD float mixed(std::uint32_t i, const AndersonPoint& now,
                           float AndersonPoint::*part) const {
    float value = now.*part;
    if (used >= 1)
      value -= last_weight * (now.*part - last[i].*part);
    if (used >= 2)
      value -= before_weight * (last[i].*part - before[i].*part);
    return value;
  }
};

class AndersonAcceleration {
 public:
  struct Products {
    double rr = 0, lr = 0, ll = 0, br = 0, bl = 0, bb = 0;
    SPINDRIFT_HD static Products of(double r, double last, double before) {
      return {r * r, last * r, last * last, before * r, before * last, before * before};
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

  /// Forgets all steps.
  void start() { known_ = 0; }

  /// Finds the best combination of the present step, now(i) for i in [0, count), with those before.
  template <class F>
  AndersonView combine(Executor& executor, std::uint32_t count, F now) {
    for (Array<AndersonPoint>* step : {&last_, &before_})
      resize_with_room(*step, count);
    const AndersonPoint *last_step = last_.data(), *step_before = before_.data();
    const int known = known_;
    weigh(executor.reduce<Products>("accelerate", count, [=] SPINDRIFT_HD(std::uint32_t i) {
      const float r = now(i).residual, r1 = last_step[i].residual;
      const float last = known >= 1 ? r - r1 : 0.f;
      const float before = known >= 2 ? r1 - step_before[i].residual : 0.f;
      return Products::of(r, last, before);
    }));
    return {last_.data(), before_.data(), used_, last_weight_, before_weight_};
  }

  /// After every unknown was kept.
  void advance() { last_.swap(before_); }

  std::size_t memory_bytes() const {
    return (last_.capacity() + before_.capacity()) * sizeof(AndersonPoint);
  }

 private:
  static constexpr std::size_t memory = 2;

  void weigh(const Products& s) {
    // A residual that grew has left the region where the steps told anything: start anew from here.
    constexpr double growth = 1.5;
    if (known_ > 0 && s.rr > growth * growth * squared_residual_)
      known_ = 0;
    squared_residual_ = s.rr;
    used_ = known_;
    known_ = std::min(known_ + 1, static_cast<int>(memory));
    last_weight_ = before_weight_ = 0;
    const double determinant = s.ll * s.bb - s.bl * s.bl;
    if (used_ == 2 && determinant > 1e-6 * s.ll * s.bb) {
      last_weight_ = weight((s.lr * s.bb - s.bl * s.br) / determinant);
      before_weight_ = weight((s.ll * s.br - s.bl * s.lr) / determinant);
    } else if (used_ >= 1 && s.ll > 0) {
      last_weight_ = weight(s.lr / s.ll);
    }
  }

  static float weight(double w) { return static_cast<float>(std::clamp(w, -10., 10.)); }

  Array<AndersonPoint> last_, before_;
  int known_ = 0;                              ///< earlier steps in memory
  int used_ = 0;                               ///< of them in the combination
  float last_weight_ = 0, before_weight_ = 0;  ///< θ₁ and θ₂
  double squared_residual_ = 0;                ///< |rₖ|²
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
