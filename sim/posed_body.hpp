// A body that moves, over one step: where it is at its end, and how it got there.
#pragma once

#include <vector>

#include "sim/motion.hpp"
#include "sim/real.hpp"
#include "sim/settings.hpp"

namespace spindrift::sim {

/// x ↦ M x + t.
struct Affine {
  Vec3<float> row_x{1, 0, 0}, row_y{0, 1, 0}, row_z{0, 0, 1};  ///< of M
  Vec3<float> offset{0, 0, 0};                                 ///< t

  Vec3<float> operator()(const Vec3<float>& p) const {
    return Vec3<float>{dot(row_x, p), dot(row_y, p), dot(row_z, p)} + offset;
  }
  /// Where it takes to p, if M is a rotation.
  Vec3<float> back(const Vec3<float>& p) const {
    const Vec3<float> d = p - offset;
    return d.x * row_x + d.y * row_y + d.z * row_z;
  }
};

/// Inner faces of the domain, m; infinitely far away where a face is open.
struct Inside {
  Vec3<float> min, max;

  Inside() = default;
  explicit Inside(const DomainSettings& domain);

  /// The nearest point at least a distance (m) away from every face.
  Vec3<float> nudged(const Vec3<float>& p, float distance) const;

  /// How far beyond the farthest of the faces that it is beyond a point is, m; negative inside.
  float beyond(const Vec3<float>& p) const;
};

struct PosedBody {
  const Shape* shape = nullptr;  ///< where the scene puts it
  Box bounds;                    ///< of the shape, m
  Inside domain;
  Affine start, pose;  ///< to where it is at the start and at the end of the step
  Affine velocity;     ///< from the shape's points to their mean velocity over it, m/s
  float spacing = 0;   ///< of the particles, m
  float reach = 0;     ///< how far a particle may go at once, so that it does not pass the body, m

  /// The point itself, or, for one in the body at its end, one on its surface that is inside the
  /// domain: the body may lie flush against a wall, or stick out through it. There the nearest
  /// point of the surface can be in the wall.
  Vec3<float> hold(const Vec3<float>& p) const;

  /// The same for a particle that comes from `from`: it does not pass the body, however fast both
  /// are. In the body's frame it goes a straight way, in short pieces.
  Vec3<float> sweep(const Vec3<float>& from, const Vec3<float>& p) const;

  /// Whether a point, or, for one on a wall, a point just off it, is in the body at its end.
  bool holds(const Vec3<float>& p) const;

  /// How deep below the surface a point is, m; 0 outside.
  float depth(const Vec3<float>& p) const;
};

/// The bodies of all obstacles that move, over a step between two times, s.
std::vector<PosedBody> posed_bodies(const Settings& settings, double start, double end);

}  // namespace spindrift::sim
