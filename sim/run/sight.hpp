// What can be seen of the liquid from a place, past walls and obstacles.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "sim/run/simulation.hpp"

namespace spindrift::sim {

class Sight {
 public:
  /// Nothing is in the way.
  Sight() = default;
  /// Obstacles as they are at a time, s.
  Sight(const Settings& settings, double time);

  /// Whether the straight way between two places, m, is free of obstacles; the second place may lie
  /// on the surface of one, which counts within a thousandth of a spacing.
  bool is_free(const glm::vec3& from, const glm::vec3& to) const;

 private:
  struct Obstacles;
  std::shared_ptr<const Obstacles> obstacles_;  ///< none: nothing is in the way
};

/// A frame without the liquid that is still in nozzles behind the domain's closed faces, where none
/// is to be seen; with all its other particles in their order.
Frame in_sight(const Settings& settings, Frame frame);

}  // namespace spindrift::sim
