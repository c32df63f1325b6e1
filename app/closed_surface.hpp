// Triangles as files hold them, made into the closed surface of a solid.
#pragma once

#include <stdexcept>

#include "sim/shapes/triangle_tree.hpp"

namespace spindrift::app {

/// A mesh that can't be used. The message says what is wrong with it, for people.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Joins vertices at the same place, leaves out triangles that have lost a corner by that, and
/// turns triangles so that neighbours wind the same way, counter-clockwise seen from outside.
/// @throws MeshError when edges are open, when no way of turning the triangles fits, or when
/// nothing is enclosed
sim::TriangleSurface closed_surface(const sim::TriangleSurface& triangles);

/// Volume inside a closed surface; negative when its triangles face inward.
double enclosed_volume(const sim::TriangleSurface& surface);

}  // namespace spindrift::app
