// Sampling and tessellation shared by the shapes with round surfaces: sphere, capsule, cylinder and
// cone.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "sim/geometry/host_device.hpp"
#include "sim/geometry/tessellation.hpp"

namespace spindrift::geometry {

/// A unit vector at right angles to an axis of unit length.
SPINDRIFT_HD inline glm::vec3 across(const glm::vec3& axis) {
  const glm::vec3 helper =
      axis.y < 0.9f && axis.y > -0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return glm::normalize(glm::cross(axis, helper));
}

/// The direction straight away from an axis of unit length, at a point a distance `r` off it, m. On
/// the axis, where rounding alone would choose it, it is any one across the axis.
/// @param radial the point's position from the axis, m
/// @param length of the axis, m
SPINDRIFT_HD inline glm::vec3 away_from_axis(const glm::vec3& axis, const glm::vec3& radial,
                                             float r, float length) {
  return r > 1e-6f * length ? radial / r : across(axis);
}

/// An orthonormal frame whose second column is `axis`, which has unit length.
glm::mat3 frame_along(const glm::vec3& axis);

/// A radius less a depth, but at least a tenth of the radius, m.
inline float radius_below(float radius, float depth) {
  return std::max(radius - depth, 0.1f * radius);
}

/// The half extents of the smallest axis-aligned box around a disc, m. The disc is at right angles
/// to `axis`, which has unit length.
inline glm::vec3 reach_of_disc(const glm::vec3& axis, float radius) {
  return radius * glm::sqrt(glm::max(1.f - axis * axis, 0.f));
}

/// The index, 0 … 2, of the coordinate axis that a line is parallel to; −1 if it is parallel to
/// none.
inline int axis_along(const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 way = glm::abs(to - from);
  for (int axis = 0; axis < 3; ++axis)
    if (way[axis] > 0 && way[(axis + 1) % 3] == 0 && way[(axis + 2) % 3] == 0)
      return axis;
  return -1;
}

/// Points on the surface of a capsule, or of a ball where `length` is 0: a spiral with equal area
/// per point, about one point per spacing². The height along the axis falls evenly, since a zone of
/// a ball has the area of a cylinder's (Archimedes), and the angle grows by the golden angle.
/// @param frame orthonormal; the second column is the axis
/// @param length between the centres of the two half balls, m
std::vector<glm::vec3> points_on_capsule(const glm::vec3& center, const glm::mat3& frame,
                                         float length, float radius, float spacing);

/// Points on the surface of a cylinder, or of a truncated cone where the radii differ: rings up the
/// side and concentric rings on both ends, about a spacing apart.
/// @param radii at `from` and at `to`, m
std::vector<glm::vec3> points_on_cone(const glm::vec3& from, const glm::vec3& to,
                                      const glm::vec2& radii, float spacing);

/// Appends the triangles of a capsule: a half ball around `top`, a half ball around `bottom`, and
/// the side between them. Where the two centres are the same, the capsule is a ball.
/// @param frame orthonormal; the second column is the axis, from bottom to top
void tessellate_capsule(Tessellation& into, const glm::vec3& bottom, const glm::vec3& top,
                        float radius, const glm::mat3& frame);

/// Appends the triangles of a cylinder, or of a truncated cone where the radii differ, with its
/// ends.
/// @param radii at `from` and at `to`, m
void tessellate_cone(Tessellation& into, const glm::vec3& from, const glm::vec3& to,
                     const glm::vec2& radii);

}  // namespace spindrift::geometry
