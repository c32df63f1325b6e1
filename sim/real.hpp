// Arithmetic types of the per-particle formulas. A formula is a template over its number type:
// `float` for one neighbour at a time, `Lanes` for eight at once on the processor.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/host_device.hpp"
#ifndef SPINDRIFT_DEVICE
#include "sim/openmp/lanes.hpp"
#endif

namespace spindrift::sim {

SPINDRIFT_HD inline float square_root(float x) {
  return std::sqrt(x);
}

SPINDRIFT_HD inline float rounded_down(float x) {
  return std::floor(x);
}

/// The elements `j` of an array.
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

/// Of components that are eight lanes each, their sums.
template <class Real>
Vec3<float> reduce(const Vec3<Real>& a) {
  return {reduce(a.x), reduce(a.y), reduce(a.z)};
}

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
