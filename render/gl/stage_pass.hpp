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

/// Fills the picture with the bytes of another one; to be drawn first.
class Copy {
 public:
  Copy();
  void draw(const TextureView& encoded) const;

 private:
  Program program_;
  VertexArray no_attributes_;
};

class Edges {
 public:
  Edges();
  void draw() const;

 private:
  Program program_;
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
