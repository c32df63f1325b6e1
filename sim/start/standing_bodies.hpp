// Obstacles as they stand at the start, fixed or moving: what liquid is left out of.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/geometry/box_tree.hpp"
#include "sim/geometry/solid.hpp"

namespace spindrift::sim {

class StandingBodies {
 public:
  explicit StandingBodies(const Settings& settings);

  struct Part {
    double inside = 0;     ///< part of the cell that is in a body
    std::size_t body = 0;  ///< the one that it is in for the most part
  };
  /// How much of a lattice's cell is in bodies. @param center, step of the lattice, m
  Part part_inside(const glm::vec3& center, const glm::vec3& step) const;

  /// The point, or the nearest one on the surface of a body that it is in, m.
  glm::vec3 push_out(glm::vec3 p) const;

  /// Points half a spacing below the bodies' surfaces, about one per spacing², inside a box, m.
  std::vector<glm::vec3> samples_in(const Box& box, float spacing) const;

 private:
  struct Body {
    const Shape* shape;
    Solid solid;  ///< where the scene puts it
    Pose pose;    ///< to where it stands

    glm::vec3 back(const glm::vec3& p) const {
      return glm::vec3(glm::transpose(pose.rotation) * (glm::dvec3(p) - pose.translation));
    }
  };
  static int count_inside(const Body& body, const Box& bounds, const glm::vec3& first,
                          const glm::vec3& between);

  std::vector<Body> bodies_;
  BoxTree places_;  ///< of the bodies' bounds where they stand
};

}  // namespace spindrift::sim
