// The liquid's particles as a structure of arrays, and the types of those arrays. Every array has
// room beyond its end for the sentinel, a point far from all others that pads neighbour lists.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <tuple>

#include "sim/backend/backend.hpp"
#include "sim/core/from_glm.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Resizes an array to n elements and those that follow: the sentinel, and one whole batch beyond
/// the end. An array that grows reserves a sixteenth more than it needs, where a vector by itself
/// would take twice the memory.
template <class T>
void resize_with_room(Array<T>& values, std::uint32_t n) {
  const std::size_t size = n + std::size_t{2 * lane_count};
  if (!values.empty() && size > values.capacity())
    values.reserve(size + size / 16);
  values.resize(size, T{});
}

/// A resizable array of numbers with room for the sentinel and one whole batch beyond its end.
template <class T>
class NumberField {
 public:
  void resize(std::uint32_t n) { resize_with_room(values_, n); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  /// Resizes to n elements, which keep the values they had, and returns the data.
  T* resized(std::uint32_t n) {
    resize(n);
    return data();
  }
  bool empty() const { return values_.empty(); }
  T& operator[](std::uint32_t i) { return values_[i]; }
  T operator[](std::uint32_t i) const { return values_[i]; }
  void fill(T value) { set_all(values_, value); }
  void swap(NumberField& other) { values_.swap(other.values_); }
  /// The backend's array, for operations on arrays as a whole.
  Array<T>& array() { return values_; }
  std::size_t memory_bytes() const { return bytes_of(values_); }

 private:
  Array<T> values_;
};

using ScalarField = NumberField<float>;
using IdField = NumberField<std::uint32_t>;

/// One vector per particle, as three arrays. at() is for the host, once the device has been waited
/// for.
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
  bool empty() const { return components_[0].empty(); }
  void fill(float value) {
    for (ScalarField& c : components_)
      c.fill(value);
  }
  glm::vec3 at(std::uint32_t i) const {
    return {components_[0][i], components_[1][i], components_[2][i]};
  }
  std::size_t memory_bytes() const { return 3 * bytes_of(components_[0]); }

 private:
  ScalarField components_[3];
};

/// One point and one number per particle, side by side in memory (PointRow).
class PointField {
 public:
  void resize(std::uint32_t n) { resize_with_room(rows_, n); }
  bool empty() const { return rows_.empty(); }
  PointView view() { return {rows_.data()}; }
  glm::vec3 at(std::uint32_t i) const { return {rows_[i].x, rows_[i].y, rows_[i].z}; }
  float value(std::uint32_t i) const { return rows_[i].value; }
  float& value(std::uint32_t i) { return rows_[i].value; }
  void swap(PointField& other) { rows_.swap(other.rows_); }
  std::size_t memory_bytes() const { return bytes_of(rows_); }

 private:
  Array<PointRow> rows_;
};

/// How long the value that a field has for a particle stays valid.
enum class Lifetime {
  state,    ///< from step to step: it comes and goes with its particle, and is sorted with it
  step,     ///< from the drift to the end of the step, through the sort between them
  scratch,  ///< from where it is computed until particles are sorted or measured again
};

/// A description of one of the fields of Particles.
template <class Field>
struct FieldOfParticles {
  std::string_view name, unit, meaning;
  Lifetime lifetime;
  Field member;           ///< pointer to the member of Particles
  bool optional = false;  ///< whether the field is empty where no part of the scene needs it
};
template <class Field>
FieldOfParticles(std::string_view, std::string_view, std::string_view, Lifetime, Field,
                 bool = false) -> FieldOfParticles<Field>;

/// All particles of the liquid. The list `fields` says what each field means, and drives whatever
/// is done to all of them.
struct Particles {
  std::uint32_t count = 0;

  VectorField position, velocity;
  ScalarField pressure;
  IdField ids;
  ScalarField held;
  ScalarField compression;
  ScalarField mean_pressure;
  PointField drifted_position, drifted_velocity;
  PointField corrected_position;
  VectorField acceleration;
  ScalarField density_ratio;
  ScalarField excess;

  static constexpr auto fields = std::tuple{
      FieldOfParticles{"position", "m", "where it is", Lifetime::state, &Particles::position},
      FieldOfParticles{"velocity", "m/s",
                       "over the last step (leapfrog: at the middle of that step)", Lifetime::state,
                       &Particles::velocity},
      FieldOfParticles{"pressure", "Pa", "what stands for it in the equations of the last step",
                       Lifetime::state, &Particles::pressure},
      FieldOfParticles{"ids", "1", "its number, never used twice", Lifetime::state,
                       &Particles::ids},
      FieldOfParticles{"held", "1", "1: a nozzle moves it, and nothing else; 0: it is free",
                       Lifetime::state, &Particles::held, true},
      FieldOfParticles{"compression", "1",
                       "ρ/ρ₀ − 1 that the last step left over: above zero, or below it where there "
                       "is pressure; of solvers that correct it",
                       Lifetime::state, &Particles::compression, true},
      FieldOfParticles{"mean_pressure", "Pa s",
                       "sum of pressure times time since the last frame; at a frame the mechanical "
                       "pressure, Pa, the mean over that time",
                       Lifetime::state, &Particles::mean_pressure, true},
      FieldOfParticles{"drifted_position", "m, Pa",
                       "where it is about to be, but for pressure; with the iterate of this step's "
                       "pressure",
                       Lifetime::step, &Particles::drifted_position},
      FieldOfParticles{"drifted_velocity", "m/s", "with all but pressure", Lifetime::step,
                       &Particles::drifted_velocity},
      FieldOfParticles{"corrected_position", "m, Pa",
                       "with pressure; with the pressure that eases positions, or another that is "
                       "summed up",
                       Lifetime::scratch, &Particles::corrected_position},
      FieldOfParticles{"acceleration", "m/s²", "by pressure", Lifetime::scratch,
                       &Particles::acceleration},
      FieldOfParticles{"density_ratio", "1", "ρ/ρ₀", Lifetime::scratch, &Particles::density_ratio},
      FieldOfParticles{"excess", "1", "compression that this step may leave as it is",
                       Lifetime::scratch, &Particles::excess, true}};

  // Other names for memory of the fields above, for what stands in it at other times of a step.

  /// Velocity changes by one force, m/s, before the pressure solve.
  VectorField& velocity_change() { return acceleration; }
  /// Search directions of the viscous velocity changes, m/s, before the pressure solve.
  PointField& search_direction() { return corrected_position; }
  /// ρ/ρ₀ at the eased positions (PressureSolver::finish), after the step.
  ScalarField& eased_density_ratio() { return excess; }
  /// Scratch memory for bringing a scalar field into another order.
  ScalarField& spare() { return density_ratio; }
  /// Scratch memory for bringing a point field into another order.
  PointField& spare_points() { return corrected_position; }

  /// Calls f(description, field) for each of `fields` but optional ones that are empty.
  template <class F>
  void for_each_field(F f) {
    std::apply(
        [&](const auto&... field) {
          const auto visit = [&](const auto& one) {
            if (!one.optional || !(this->*one.member).empty())
              f(one, this->*one.member);
          };
          (visit(field), ...);
        },
        fields);
  }

  /// Resizes all fields but optional ones that are empty.
  void resize(std::uint32_t n) {
    count = n;
    for_each_field([n](const auto&, auto& field) { field.resize(n); });
  }

  std::size_t memory_bytes() const {
    return std::apply([this](const auto&... field) { return bytes_of(this->*field.member...); },
                      fields);
  }
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
