// The liquid's particles as a structure of arrays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>

#include "sim/backend/backend.hpp"
#include "sim/core/from_glm.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Makes an array one of n elements and those that follow: the sentinel, and one whole batch beyond
/// the end. A vector by itself would take twice the memory as soon as it grows a little.
template <class T>
void resize_with_room(Array<T>& values, std::uint32_t n) {
  const std::size_t size = n + std::size_t{2 * lane_count};
  if (!values.empty() && size > values.capacity())
    values.reserve(size + size / 16);
  values.resize(size, T{});
}

/// A resizable array of floats with room for the sentinel and one whole batch beyond its end.
class ScalarField {
 public:
  void resize(std::uint32_t n) { resize_with_room(values_, n); }
  float* data() { return values_.data(); }
  const float* data() const { return values_.data(); }
  /// The data of n elements; those that were there keep their values.
  float* resized(std::uint32_t n) {
    resize(n);
    return data();
  }
  bool empty() const { return values_.empty(); }
  float& operator[](std::uint32_t i) { return values_[i]; }
  float operator[](std::uint32_t i) const { return values_[i]; }
  void fill(float value) { set_all(values_, value); }
  void swap(ScalarField& other) { values_.swap(other.values_); }
  std::size_t memory_bytes() const { return values_.capacity() * sizeof(float); }

 private:
  Array<float> values_;
};

/// One vector per particle, as three arrays.
class VectorField {
 public:
  void resize(std::uint32_t n) {
    for (ScalarField& c : components_)
      c.resize(n);
  }
  Vec3Arrays view() {
    return {components_[0].data(), components_[1].data(), components_[2].data()};
  }
  ScalarField& component(int c) { return components_[c]; }
  void fill(float value) {
    for (ScalarField& c : components_)
      c.fill(value);
  }
  glm::vec3 at(std::uint32_t i) const {
    return {components_[0][i], components_[1][i], components_[2][i]};
  }
  std::size_t memory_bytes() const { return 3 * components_[0].memory_bytes(); }

 private:
  ScalarField components_[3];
};

/// Points with a number each, side by side.
class PointField {
 public:
  void resize(std::uint32_t n) { resize_with_room(rows_, n); }
  PointView view() { return {rows_.data()}; }
  glm::vec3 at(std::uint32_t i) const { return {rows_[i].x, rows_[i].y, rows_[i].z}; }
  float value(std::uint32_t i) const { return rows_[i].value; }
  float& value(std::uint32_t i) { return rows_[i].value; }
  void swap(PointField& other) { rows_.swap(other.rows_); }
  std::size_t memory_bytes() const { return rows_.capacity() * sizeof(PointRow); }

 private:
  Array<PointRow> rows_;
};

/// State that lasts from step to step, and what a step needs besides.
struct Particles {
  std::uint32_t count = 0;

  // State at the current time. A step that is rejected leaves it as it was, but for the order.
  VectorField position;      ///< m
  VectorField velocity;      ///< m/s, over the last step (leapfrog: at the middle of that step)
  ScalarField pressure;      ///< Pa, of the last step
  Array<std::uint32_t> ids;  ///< never used twice
  /// ρ/ρ₀ − 1 that the last step left over: above zero, or below it where there is pressure. Only
  /// with a solver that corrects it; empty else.
  ScalarField compression;
  /// At a frame the mechanical pressure, Pa, the mean over the time since the last one; between
  /// frames the sum of pressure times time since then, Pa·s. Empty before the first step.
  ScalarField mean_pressure;

  // Within a step.
  /// Where particles are about to be, but for pressure, m; with the iterate of this step's
  /// pressure, Pa.
  PointField drifted_position;
  PointField drifted_velocity;  ///< with all but pressure, m/s
  VectorField acceleration;     ///< viscous, then by pressure, m/s²
  /// With pressure, m; with the pressure that eases positions, Pa, or another that is summed up.
  PointField corrected_position;
  ScalarField density_ratio;  ///< ρ/ρ₀
  ScalarField excess;         ///< compression that this step may leave as it is

  void resize(std::uint32_t n) {
    count = n;
    for (VectorField* f : {&position, &velocity, &acceleration})
      f->resize(n);
    for (PointField* f : {&drifted_position, &drifted_velocity, &corrected_position})
      f->resize(n);
    for (ScalarField* f : {&pressure, &density_ratio})
      f->resize(n);
    ids.resize(n);
  }

  std::size_t memory_bytes() const {
    return 3 * position.memory_bytes() + 3 * drifted_position.memory_bytes() +
           2 * pressure.memory_bytes() + compression.memory_bytes() + mean_pressure.memory_bytes() +
           excess.memory_bytes() + ids.capacity() * sizeof(std::uint32_t);
  }
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
