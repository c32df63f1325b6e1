// The obstacles, fixed or moving, where they stand at time 0: the bodies that the initial liquid is
// kept out of.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/geometry/box_tree.hpp"
#include "sim/geometry/solid.hpp"

namespace spindrift::sim {

/// All obstacles of a scene at time 0.
class StandingBodies {
 public:
  /// @param settings must outlive this object
  explicit StandingBodies(const Settings& settings);

  /// How much of a lattice's cell is inside bodies.
  struct Part {
    double inside = 0;     ///< the fraction of the cell that is in bodies, 0 … 1
    std::size_t body = 0;  ///< index of the body that contains most of it
  };
  /// @param center of the cell, m
  /// @param step the cell's edges, m
  Part part_inside(const glm::vec3& center, const glm::vec3& step) const;

  /// The point itself, or, if it is in a body, the nearest point on the body's surface, m. One that
  /// is then in another body is pushed out of that, too.
  glm::vec3 push_out(glm::vec3 p) const;

  /// The positions of the bodies' boundary particles in a box, m: half a spacing (m) below the
  /// surfaces, about one per spacing².
  std::vector<glm::vec3> samples_in(const Box& box, float spacing) const;

 private:
  struct Body {
    const Shape* shape;
    Solid solid;  ///< where the scene places it
    Pose pose;    ///< from there to where it stands at time 0

    /// The point of `solid` that the pose takes to p, m.
    glm::vec3 back(const glm::vec3& p) const {
      return glm::vec3(glm::transpose(pose.rotation) * (glm::dvec3(p) - pose.translation));
    }
  };
  static int count_inside(const Body& body, const Box& bounds, const glm::vec3& first,
                          const glm::vec3& between);

  std::vector<Body> bodies_;
  BoxTree places_;  ///< bounding boxes of the bodies where they stand
};

}  // namespace spindrift::sim
