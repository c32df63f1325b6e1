// The liquid's surface: first how thick the liquid is behind each pixel, then its shading.
#pragma once

#include <optional>

#include "render/gl/mesh_buffers.hpp"

namespace spindrift::gl {

class LiquidPass {
 public:
  LiquidPass(int width, int height);

  /// Measures how thick the liquid is behind each pixel, up to the obstacles (null: there are
  /// none).
  void measure(const MeshBuffers& liquid, const MeshBuffers* obstacles);
  /// Draws the liquid as measured last; `behind` is the picture that is seen through
  /// it, sRGB-encoded.
  void draw(const MeshBuffers& liquid, const TextureView& behind) const;

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
  Program thickness_program_, shading_program_;
  Texture thickness_, no_obstacles_;
  Framebuffer thickness_target_;
  std::optional<ObstacleRange> obstacle_range_;
};

}  // namespace spindrift::gl
