// Draws the liquid's surface: it finds how thick the liquid is behind each pixel and what the
// nearest surfaces are (with four samples per pixel), and shades these once per pixel.
#pragma once

#include <optional>

#include "render/gl/objects/canvas.hpp"
#include "render/gl/objects/mesh_buffers.hpp"
#include "render/gl/objects/tiles.hpp"

namespace spindrift::gl {

/// Draws a liquid's mesh with measure(), outline() and shade(), in this order.
class LiquidPass {
 public:
  /// @param width, height pixels of the picture
  LiquidPass(int width, int height);

  /// Measures how thick the liquid is behind each pixel, up to the obstacles (null where there are
  /// none).
  void measure(const MeshBuffers& liquid, const MeshBuffers* obstacles);
  /// Notes normals and depth of the nearest surfaces of the liquid and of the obstacles (null where
  /// there are none); of the obstacles, without what is under the floor when `above_floor` is set.
  void outline(const MeshBuffers& liquid, const MeshBuffers* obstacles, bool above_floor) const;
  /// Lights the surfaces noted last and draws them over `picture`, in the given tiles only;
  /// `behind` is what is seen through the liquid, sRGB-encoded.
  void shade(const Picture& picture, const TextureView& behind, bool has_obstacles,
             Tiles& tiles) const;
  /// Depth of the surfaces noted last.
  const MultisampleTexture& depth() const { return surfaces_.depth(); }

 private:
  /// Measures how far away obstacles are, so that liquid behind them does not count.
  struct ObstacleRange {
    ObstacleRange(int width, int height);
    void measure(const MeshBuffers& obstacles) const;
    Program program;
    Texture range;
    Renderbuffer depth;
    Framebuffer framebuffer;
  };

  int width_, height_;  ///< texels of the thickness map: half the picture's pixels, rounded up
  Program thickness_program_, liquid_normal_program_, obstacle_normal_program_, shading_program_;
  Samples surfaces_;
  Texture thickness_, no_obstacles_;
  Framebuffer thickness_target_;
  std::optional<ObstacleRange> obstacle_range_;
};

}  // namespace spindrift::gl
