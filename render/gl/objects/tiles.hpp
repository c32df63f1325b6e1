// Finds the part of the picture that meshes cover, in square tiles, so that what is done once per
// pixel of a surface is done there only.
#pragma once

#include <vector>

#include "render/gl/objects/gl_objects.hpp"
#include "render/mesh.hpp"

namespace spindrift::gl {

/// A set of the picture's tiles.
class Tiles {
 public:
  /// @param width, height pixels of the picture
  Tiles(int width, int height);

  /// Removes all tiles from the set.
  void clear();
  /// Adds all tiles that the mesh may touch.
  void add(const Mesh& mesh, const glm::mat4& world_to_clip);
  /// Draws the tiles of the set as triangles with the program in use; attribute 0 is the corner's
  /// place in the picture, in [-1, 1].
  void draw();

 private:
  int width_, height_, columns_, rows_;
  std::vector<unsigned char> touched_;
  std::vector<glm::ivec2> places_;
  std::vector<glm::vec2> corners_;
  VertexArray array_;
  Buffer buffer_;
};

}  // namespace spindrift::gl
