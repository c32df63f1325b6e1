// Arithmetic types of the per-particle formulas. A formula is a template over its number type:
// `float` for one neighbour at a time, `Lanes` for eight at once on the CPU.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/geometry/host_device.hpp"
#ifndef SPINDRIFT_DEVICE
#include "sim/core/lanes.hpp"
#endif

namespace spindrift::sim {

SPINDRIFT_HD inline float square_root(float x) {
  return std::sqrt(x);
}

SPINDRIFT_HD inline float rounded_down(float x) {
  return std::floor(x);
}

SPINDRIFT_HD inline float at_least(float x, float least) {
  return x > least ? x : least;
}

/// The positive part of x: x, or zero where it is negative.
template <class Real>
SPINDRIFT_HD Real positive(Real x) {
  return at_least(x, 0.f);
}

/// Element j of an array.
SPINDRIFT_HD inline float load(const float* a, std::uint32_t j) {
  return a[j];
}

template <class Real>
struct Vec3 {
  Real x, y, z;
};

template <class A, class B>
SPINDRIFT_HD inline auto operator+(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
SPINDRIFT_HD inline auto operator-(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class A>
SPINDRIFT_HD inline auto operator*(S s, const Vec3<A>& a) {
  return Vec3<decltype(s * a.x)>{s * a.x, s * a.y, s * a.z};
}
template <class A>
SPINDRIFT_HD inline Vec3<A>& operator+=(Vec3<A>& a, const Vec3<A>& b) {
  a = a + b;
  return a;
}
template <class A>
SPINDRIFT_HD inline A dot(const Vec3<A>& a, const Vec3<A>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The sums of each component over its eight lanes.
template <class Real>
Vec3<float> reduce(const Vec3<Real>& a) {
  return {reduce(a.x), reduce(a.y), reduce(a.z)};
}

/// A point in space, m, and a number that is wanted wherever the point is. They stand beside each
/// other so that one memory access brings all that is to be known of a neighbour.
struct alignas(16) PointRow {
  float x, y, z, value;
};
#ifndef SPINDRIFT_DEVICE
static_assert(sizeof(PointRow) == LaneList::place_of(1));
#endif

/// Row j of an array.
SPINDRIFT_HD inline PointRow load(const PointRow* rows, std::uint32_t j) {
  return rows[j];
}

#ifndef SPINDRIFT_DEVICE
inline LaneRows load(const PointRow* rows, LaneList list) {
  const auto* const bytes = reinterpret_cast<const char*>(rows);
  return transposed([&](int k) { return reinterpret_cast<const float*>(bytes + list.places[k]); });
}
inline LaneRows load(const PointRow* rows, LaneRun run) {
  return transposed([&](int k) { return &rows[run.first + static_cast<std::uint32_t>(k)].x; });
}
#endif

/// The position, m, and the number of one neighbour (`float`) or of eight (`Lanes`).
template <class Real>
struct Point {
  Vec3<Real> position;
  Real value;
};

/// An array of points with a number each. An index is one number, or a LaneList or LaneRun of eight
/// on the CPU.
struct PointView {
  PointRow* rows = nullptr;

  template <class Index>
  SPINDRIFT_HD auto point(Index j) const {
    const auto row = load(rows, j);
    return Point<decltype(row.x + row.x)>{{row.x, row.y, row.z}, row.value};
  }
  template <class Index>
  SPINDRIFT_HD auto operator[](Index j) const {
    return point(j).position;
  }
  /// Sets the position of point i, and leaves its number.
  SPINDRIFT_HD void set(std::uint32_t i, const Vec3<float>& p) const {
    rows[i] = {p.x, p.y, p.z, rows[i].value};
  }
  SPINDRIFT_HD float& value(std::uint32_t i) const { return rows[i].value; }
};

/// Three arrays that hold one vector per particle.
struct Vec3Arrays {
  float* x = nullptr;
  float* y = nullptr;
  float* z = nullptr;

  template <class Index>
  SPINDRIFT_HD auto operator[](Index j) const {
    return Vec3<decltype(load(x, j))>{load(x, j), load(y, j), load(z, j)};
  }
  SPINDRIFT_HD void set(std::uint32_t i, const Vec3<float>& v) const {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

}  // namespace spindrift::sim
