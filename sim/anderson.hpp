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

/// The present iterates and residuals and those of the two steps before, to be combined.
struct AndersonView {
  const float *iterate, *last_iterate, *iterate_before;
  const float *residual, *last_residual, *residual_before;
  int used;                          ///< earlier steps in the combination
  float last_weight, before_weight;  ///< θ₁ and θ₂

  /// The best combination at i.
  SPINDRIFT_HD AndersonPoint at(std::uint32_t i) const {
    return {mixed(i, iterate, last_iterate, iterate_before),
            mixed(i, residual, last_residual, residual_before)};
  }

  SPINDRIFT_HD float mixed(std::uint32_t i, const float* now, const float* last,
                           const float* before) const {
    float value = now[i];
    if (used >= 1)
      value -= last_weight * (now[i] - last[i]);
    if (used >= 2)
      value -= before_weight * (last[i] - before[i]);
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

  /// Takes in the present iterate and residual, point_of(i) for i in [0, count), and finds their
  /// best combination with those before.
  template <class F>
  void add(Executor& executor, std::uint32_t count, F point_of) {
    for (std::size_t k = memory; k > 0; --k) {
      iterates_[k].swap(iterates_[k - 1]);
      residuals_[k].swap(residuals_[k - 1]);
    }
    for (ScalarField* field : {iterates_, residuals_})
      for (std::size_t k = 0; k <= memory; ++k)
        field[k].resize(count);
    float *p = iterates_[0].data(), *r0 = residuals_[0].data();
    const float *r1 = residuals_[1].data(), *r2 = residuals_[2].data();
    const int known = known_;
    const Products sums =
        executor.reduce<Products>("accelerate", count, [=] SPINDRIFT_HD(std::uint32_t i) {
          const AndersonPoint point = point_of(i);
          p[i] = point.iterate;
          r0[i] = point.residual;
          const float last = known >= 1 ? point.residual - r1[i] : 0.f;
          const float before = known >= 2 ? r1[i] - r2[i] : 0.f;
          return Products::of(point.residual, last, before);
        });
    combine(sums);
  }

  AndersonView view() const {
    return {iterates_[0].data(),
            iterates_[1].data(),
            iterates_[2].data(),
            residuals_[0].data(),
            residuals_[1].data(),
            residuals_[2].data(),
            used_,
            last_weight_,
            before_weight_};
  }

  std::size_t memory_bytes() const { return 2 * (memory + 1) * iterates_[0].memory_bytes(); }

 private:
  static constexpr std::size_t memory = 2;

  void combine(const Products& s) {
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

  ScalarField iterates_[memory + 1], residuals_[memory + 1];  ///< the present ones first
  int known_ = 0;                                             ///< earlier steps in memory
  int used_ = 0;                                              ///< of them in the combination
  float last_weight_ = 0, before_weight_ = 0;                 ///< θ₁ and θ₂
  double squared_residual_ = 0;                               ///< |rₖ|²
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
