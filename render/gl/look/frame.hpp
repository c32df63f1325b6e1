// Computes the uniforms that every shader sees (the block `Frame` of shaders/common.glsl).
#pragma once

#include "render/gl/look/look.hpp"

namespace spindrift::gl {

/// An axis-aligned box, m.
struct Bounds {
  glm::vec3 min, max;
};

/// The uniforms as they lie in the block, in the layout std140: every member is a multiple of 16
/// bytes. shaders/common.glsl says what each of them means.
struct FrameUniforms {
  glm::mat4 world_to_clip, world_to_shadow;
  glm::vec4 eye, ray, ray_x, ray_y, light, radiance;
  glm::vec4 liquid_color, liquid_absorption, gloss, obstacle_color;
  glm::vec4 background_top, background_bottom, floor_color, stage_min, stage_max, viewport;
  glm::vec4 depth_scale;

  bool operator==(const FrameUniforms&) const = default;
};

/// Returns the uniforms of one picture.
/// @param casters       bounds of all that may throw a shadow on the floor
/// @param width, height pixels of the picture
FrameUniforms frame_uniforms(const View& view, const LookSettings& look, const LightSettings& light,
                             const Stage& stage, const Bounds& casters, int width, int height);

/// The part of the floor that the shadow map covers, m along x and z. It is empty when the light
/// does not come from above, or comes from too low to throw a shadow.
struct ShadowArea {
  glm::vec2 min{0.f}, max{0.f};
  bool empty() const { return max.x <= min.x; }
};
/// Returns the matrix that projects points along the light onto the floor and maps the area to
/// [-1, 1]; depth is left out.
/// @param light direction in which the light travels
/// @param floor height of the floor, m
glm::mat4 world_to_shadow(glm::vec3 light, float floor, const ShadowArea& area);
/// Returns the part of the floor that the shadow of `casters`, with its soft rim, may reach.
ShadowArea shadow_area(const LightSettings& light, const Stage& stage, const Bounds& casters);

}  // namespace spindrift::gl
