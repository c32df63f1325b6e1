// The liquid's surface: how thick the liquid is behind each pixel, what the nearest surfaces are
// (with four samples per pixel), and their shading, once per pixel.
#pragma once

#include <optional>

#include "render/gl/canvas.hpp"
#include "render/gl/mesh_buffers.hpp"
#include "render/gl/tiles.hpp"

namespace spindrift::gl {

class LiquidPass {
 public:
  LiquidPass(int width, int height);

  /// Measures how thick the liquid is behind each pixel, up to the obstacles (null: there are
  /// none).
  void measure(const MeshBuffers& liquid, const MeshBuffers* obstacles);
  /// Notes the nearest surfaces of the liquid and the obstacles (null: there are none), the latter
  /// without what is under the floor when `above_floor` is set.
  void outline(const MeshBuffers& liquid, const MeshBuffers* obstacles, bool above_floor) const;
  /// Lights the surfaces noted last, over `picture`, in the tiles they touch; `behind` is what is
  /// seen through the liquid, sRGB-encoded.
  void shade(const Picture& picture, const TextureView& behind, bool has_obstacles,
             Tiles& tiles) const;
  const MultisampleTexture& depth() const { return surfaces_.depth(); }

 private:
  /// How far away obstacles are, for liquid behind them not to count.
  struct ObstacleRange {
    ObstacleRange(int width, int height);
    void measure(const MeshBuffers& obstacles) const;
    Program program;
    Texture range;
    Renderbuffer depth;
    Framebuffer framebuffer;
  };

  int width_, height_;  ///< of the thickness map: half the picture's
  Program thickness_program_, liquid_normal_program_, obstacle_normal_program_, shading_program_;
  Samples surfaces_;
  Texture thickness_, no_obstacles_;
  Framebuffer thickness_target_;
  std::optional<ObstacleRange> obstacle_range_;
};

}  // namespace spindrift::gl
