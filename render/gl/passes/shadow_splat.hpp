// Computes how much liquid the mesh of its surface puts in the light's way, on a map of the floor.
#pragma once

#include <vector>

#include "render/gl/look/frame.hpp"
#include "render/mesh.hpp"

namespace spindrift::gl {

/// Adds up the liquid between light and floor, m along the light, on a map of width x height
/// texels. The surface's triangles are about as small as a texel, and the map is blurred later: so
/// each triangle is taken for a drop of its area and height that falls on four texels, which costs
/// a tenth of drawing it. Larger triangles are divided.
class ShadowSplat {
 public:
  /// @param world_to_shadow maps points along the light onto the floor, with the map in [-1, 1]
  /// @param light           unit direction in which the light travels
  /// @param floor           height of the floor, m
  ShadowSplat(int width, int height, const glm::mat4& world_to_shadow, glm::vec3 light,
              float floor);
  /// Returns the map for a closed surface: m of liquid along the light at every texel, rows from
  /// the map's bottom. It is valid until the next call.
  const std::vector<float>& measure(const Mesh& liquid);

 private:
  void add(glm::vec3 a, glm::vec3 b, glm::vec3 c);

  int width_, height_;
  glm::mat4 to_texels_;  ///< from the world to texels; z becomes the way to the floor, m
  std::vector<glm::vec3> places_;
  std::vector<float> blocked_;
};

}  // namespace spindrift::gl
