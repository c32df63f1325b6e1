// A cone, whole or truncated: a round body whose radius changes linearly from one flat end to the
// other.
#pragma once

#include "sim/geometry/round.hpp"
#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A cone, whole or truncated. Its members are described in `Box`.
struct Cone {
  glm::vec3 from{0.f};          ///< centre of one end, m
  glm::vec3 to{0.f, 1.f, 0.f};  ///< centre of the other end, or the tip, m
  float radius = 0.5f;          ///< radius at `from`, m
  float tip_radius = 0.f;       ///< radius at `to`, m; 0: a tip

  static constexpr std::string_view name = "cone";
  static constexpr auto fields = std::tuple{
      Field{"from", &Cone::from, "centre of its base", places, "m", Presence::required},
      Field{"to", &Cone::to, "its tip, or the centre of its other end", places, "m",
            Presence::required},
      Field{"radius", &Cone::radius, "radius of its base", lengths, "m", Presence::required},
      Field{"tip_radius", &Cone::tip_radius, "radius at the other end; 0: a tip", Range{0., 1e5},
            "m"}};

  std::string problem() const { return from == to ? "from and to are the same point" : ""; }

  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const {
    const Slope slope = this->slope();
    const glm::vec3 axis = (to - from) / slope.length;
    const float along = glm::dot(p - from, axis);
    const glm::vec3 radial = p - from - along * axis;
    const float r = glm::length(radial), width = radius - slope.narrowing * along;
    if (along <= 0 || along >= slope.length || r >= width)
      return p;
    // The body is convex, so the nearest point lies on the nearest of the three faces' planes.
    const float side = (width - r) * slope.cosine, below = along, above = slope.length - along;
    if (side <= below && side <= above) {
      const glm::vec3 out = away_from_axis(axis, radial, r, slope.length);
      return p + side * slope.cosine * (out + slope.narrowing * axis);
    }
    return below <= above ? p - below * axis : p + above * axis;
  }

  SPINDRIFT_HD Entry entry(const glm::vec3& start, const glm::vec3& way) const {
    const Slope slope = this->slope();
    const glm::vec3 axis = (to - from) / slope.length, offset = start - from;
    const float along = glm::dot(offset, axis), way_along = glm::dot(way, axis);
    Chord chord;
    chord.meet_slab(along, way_along, 0, slope.length, axis);
    meet_side(chord, offset - along * axis, way - way_along * axis, along, way_along, axis, slope);
    Entry entry;
    join_entry(chord, way, entry);
    return entry;
  }

  /// The cone with each of its three faces moved out by the margin, m.
  SPINDRIFT_HD Cone thickened(float margin) const {
    const Slope slope = this->slope();
    const glm::vec3 end = (margin / slope.length) * (to - from);
    const float wider = margin / slope.cosine, longer = margin * slope.narrowing;
    return {from - end, to + end, radius + wider + longer,
            std::max(0.f, tip_radius + wider - longer)};
  }

  Box bounds() const {
    const glm::vec3 axis = glm::normalize(to - from), base = reach_of_disc(axis, radius),
                    tip = reach_of_disc(axis, tip_radius);
    return {glm::min(from - base, to - tip), glm::max(from + base, to + tip)};
  }

  /// The distance between the two ends, m.
  double length() const { return glm::distance(glm::dvec3(from), glm::dvec3(to)); }
  double volume() const {
    const double a = radius, b = tip_radius;
    return std::numbers::pi / 3 * length() * (a * a + a * b + b * b);
  }
  double area() const {
    const double a = radius, b = tip_radius;
    return std::numbers::pi * (a * a + b * b + (a + b) * std::hypot(length(), a - b));
  }

  glm::bvec3 flat_along() const {
    const int axis = axis_along(from, to);
    return {axis == 0, axis == 1, axis == 2};
  }

  /// Samples on the surface of the cone whose three faces are moved in by half a spacing (m).
  std::vector<SurfaceSample> samples(float spacing) const {
    const Slope slope = this->slope();
    const float inset = 0.5f * spacing, thinner = inset / slope.cosine;
    const auto radius_at = [&](float along) {
      return std::max(radius - slope.narrowing * along - thinner, 0.f);
    };
    float begin = std::min(inset, 0.4f * slope.length), end = slope.length - begin;
    // Where the moved side meets in a tip before an end, the tip replaces that end.
    if (slope.narrowing > 0)
      end = std::min(end, (radius - thinner) / slope.narrowing);
    else if (slope.narrowing < 0)
      begin = std::max(begin, (radius - thinner) / slope.narrowing);
    const glm::vec3 axis = (to - from) / slope.length;
    if (!(begin < end))  // thinner than a spacing: one sample in the middle of the wider half
      return samples_at({from + (slope.narrowing > 0 ? 0.25f : 0.75f) * (to - from)});
    return samples_at(points_on_cone(from + begin * axis, from + end * axis,
                                     {radius_at(begin), radius_at(end)}, spacing));
  }

  void tessellate(Tessellation& into) const {
    tessellate_cone(into, from, to, {radius, tip_radius});
  }

  std::optional<Cone> mirrored(const Mirror& mirror) const {
    return Cone{mirror(from), mirror(to), radius, tip_radius};
  }

 private:
  struct Slope {
    float length;     ///< between the two ends, m
    float narrowing;  ///< decrease of the radius along the axis, m/m
    float cosine;     ///< cosine of the angle between the side and the axis
  };
  SPINDRIFT_HD Slope slope() const {
    const float length = glm::length(to - from), narrowing = (radius - tip_radius) / length;
    return {length, narrowing, 1 / std::sqrt(1 + narrowing * narrowing)};
  }

  /// Intersects a chord with the space within the side, |o + t w| < width(t): a quadratic
  /// inequality in t, restricted to the half of the double cone in which the width is above 0.
  /// @param offset, way the path's beginning and the path, as components across the axis, m
  /// @param along, way_along the same two as coordinates along the axis, m
  SPINDRIFT_HD void meet_side(Chord& chord, const glm::vec3& offset, const glm::vec3& way,
                              float along, float way_along, const glm::vec3& axis,
                              const Slope& slope) const {
    const double width = radius - double{slope.narrowing} * along,
                 widening = -double{slope.narrowing} * way_along;
    const glm::dvec3 o(offset), w(way);
    const double a = glm::dot(w, w) - widening * widening,
                 half_b = glm::dot(o, w) - widening * width, c = glm::dot(o, o) - width * width;
    constexpr double infinity = std::numeric_limits<float>::infinity();
    double begin = -infinity, end = infinity;
    // A path that is parallel to the side has a linear inequality.
    if (std::abs(a) <= 1e-12 * (glm::dot(w, w) + widening * widening)) {
      if (half_b > 0)
        end = -c / (2 * half_b);
      else if (half_b < 0)
        begin = -c / (2 * half_b);
      else if (c >= 0)
        return chord.miss();
    } else {
      const double discriminant = half_b * half_b - a * c;
      if (a > 0 && !(discriminant > 0))
        return chord.miss();
      const double root = std::sqrt(std::max(0., discriminant));
      const double low = (-half_b - root) / a, high = (-half_b + root) / a;
      if (a > 0) {
        begin = low;
        end = high;
      } else if (widening > 0) {  // the path stays in the half that widens along it
        begin = std::max(low, high);
      } else {
        end = std::min(low, high);
      }
    }
    const glm::dvec3 surface = o + std::max(begin, 0.) * w;
    const double length = glm::length(surface);
    const glm::vec3 out = length > 0 ? glm::vec3(surface / length) : glm::vec3(0.f);
    const glm::vec3 normal = slope.cosine * (out + slope.narrowing * axis);
    chord.meet(static_cast<float>(begin), static_cast<float>(end), normal);
  }
};

}  // namespace spindrift::geometry
