// The uniforms that every shader sees (the block `Frame` of shaders/common.glsl).
#pragma once

#include "render/gl/renderer.hpp"

namespace spindrift::gl {

/// An axis-aligned box, m.
struct Bounds {
  glm::vec3 min, max;
};

/// std140: every member is a multiple of 16 bytes. Meanings are given in shaders/common.glsl.
struct FrameUniforms {
  glm::mat4 world_to_clip, world_to_shadow;
  glm::vec4 eye, ray, ray_x, ray_y, light, radiance;
  glm::vec4 liquid_color, liquid_absorption, gloss, obstacle_color;
  glm::vec4 background_top, background_bottom, floor_color, stage_min, stage_max, viewport;
  glm::vec4 depth_scale;
};

/// The uniforms of one picture. `casters` bounds all that may throw a shadow on the floor.
FrameUniforms frame_uniforms(const View& view, const LookSettings& look, const LightSettings& light,
                             const Stage& stage, const Bounds& casters, int width, int height);

/// What the floor's shadow map covers, m along x and z. Empty when the light does not come from
/// above.
struct ShadowArea {
  glm::vec2 min{0.f}, max{0.f};
  bool empty() const { return max.x <= min.x; }
};
/// The way from a point along the light to the floor, mapped to [-1, 1]; depth is left out.
glm::mat4 world_to_shadow(glm::vec3 light, float floor, const ShadowArea& area);
ShadowArea shadow_area(const LightSettings& light, const Stage& stage, const Bounds& casters);

}  // namespace spindrift::gl
