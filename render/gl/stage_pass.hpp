// The stage: backdrop, floor, edges of the domain box.
#pragma once

#include "render/gl/gl_objects.hpp"

namespace spindrift::gl {

/// Backdrop and floor: what fills the picture where nothing stands in front of it.
class Surroundings {
 public:
  explicit Surroundings(bool floor);
  /// Fills the picture; to be drawn first. `shadow` is the light on the floor; null: all of it
  /// arrives.
  void draw(const Texture* shadow) const;

 private:
  Program program_;
  VertexArray no_attributes_;
  Texture no_shadow_;
};

class Edges {
 public:
  Edges();
  /// Draws them on a finished picture; `depth` is that of all that stands on the stage.
  void draw(const MultisampleTexture& depth) const;

 private:
  Program program_;
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
