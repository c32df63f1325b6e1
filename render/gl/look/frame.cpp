#include "render/gl/look/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace spindrift::gl {

namespace {

/// Depth of liquid that gives white light the liquid's colour, in diagonals of the stage.
constexpr float color_depth = 0.28f;
/// Distance at which the floor has faded into the backdrop, in diagonals of the stage.
constexpr float floor_reach = 4.f;
/// Least downward component of a light's unit direction with which it throws a shadow; that of a
/// flatter light would reach beyond any map.
constexpr float lowest_light = 0.2f;
/// Room around a shadow for its soft rim, as a share of the map.
constexpr float shadow_margin = 0.06f;

glm::vec3 linear_from_srgb(glm::vec3 c) {
  const auto channel = [](float x) {
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  };
  return {channel(c.x), channel(c.y), channel(c.z)};
}

struct Camera {
  glm::vec3 right, up, forward;  ///< unit vectors
};

Camera camera_of(const View& view) {
  const glm::vec3 forward = glm::normalize(view.target - view.position);
  // An up vector along the line of sight says nothing, so another is taken.
  const bool along = glm::length(glm::cross(forward, view.up)) < 1e-4f * glm::length(view.up);
  const glm::vec3 up = along ? glm::vec3(0.f, 0.f, -1.f) : view.up;
  const glm::vec3 right = glm::normalize(glm::cross(forward, up));
  return {right, glm::cross(right, forward), forward};
}

glm::mat4 view_to_clip(const View& view, const Stage& stage, float aspect) {
  const float size = glm::distance(stage.min, stage.max);
  const float range = glm::distance(view.position, 0.5f * (stage.min + stage.max));
  const float near = std::max(0.005f * size, 0.2f * (range - size));
  const float far = range + 10.f * size;
  return glm::perspective(glm::radians(view.vertical_fov), aspect, near, far);
}

}  // namespace

glm::mat4 world_to_shadow(glm::vec3 light, float floor, const ShadowArea& area) {
  if (area.empty())
    return glm::mat4(1.f);
  const glm::vec2 middle = 0.5f * (area.min + area.max);
  const glm::vec2 scale = 2.f / (area.max - area.min);
  const glm::vec2 slope(light.x / light.y, light.z / light.y);
  glm::mat4 m(0.f);
  m[0] = {scale.x, 0.f, 0.f, 0.f};
  m[1] = {-scale.x * slope.x, scale.y * slope.y, 0.f, 0.f};
  m[2] = {0.f, -scale.y, 0.f, 0.f};  // seen from above, z points down
  m[3] = {scale.x * (slope.x * floor - middle.x), -scale.y * (slope.y * floor - middle.y), 0.f,
          1.f};
  return m;
}

ShadowArea shadow_area(const LightSettings& light, const Stage& stage, const Bounds& casters) {
  const glm::vec3 direction = glm::normalize(light.direction);
  if (direction.y > -lowest_light)
    return {};
  const float floor = stage.min.y;
  const glm::vec2 slope(direction.x / direction.y, direction.z / direction.y);
  const glm::vec2 low(casters.min.x, casters.min.z), high(casters.max.x, casters.max.z);
  const glm::vec2 from_bottom = slope * std::max(casters.min.y - floor, 0.f);
  const glm::vec2 from_top = slope * std::max(casters.max.y - floor, 0.f);
  ShadowArea area{glm::min(low - from_bottom, low - from_top),
                  glm::max(high - from_bottom, high - from_top)};
  const glm::vec2 margin(shadow_margin *
                         std::max(area.max.x - area.min.x, area.max.y - area.min.y));
  return {area.min - margin, area.max + margin};
}

FrameUniforms frame_uniforms(const View& view, const LookSettings& look, const LightSettings& light,
                             const Stage& stage, const Bounds& casters, int width, int height) {
  const float stage_size = glm::distance(stage.min, stage.max);
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const float half_height = std::tan(0.5f * glm::radians(view.vertical_fov));
  const Camera camera = camera_of(view);
  const glm::vec3 liquid = linear_from_srgb(look.liquid_color);
  const glm::vec3 direction = glm::normalize(light.direction);
  FrameUniforms frame;
  const glm::mat4 lens = view_to_clip(view, stage, aspect);
  frame.world_to_clip =
      lens * glm::lookAt(view.position, view.position + camera.forward, camera.up);
  frame.world_to_shadow =
      world_to_shadow(direction, stage.min.y, shadow_area(light, stage, casters));
  frame.eye = {view.position, 2.f * half_height / static_cast<float>(height)};
  frame.ray = {camera.forward, 0.f};
  frame.ray_x = {camera.right * half_height * aspect, 0.f};
  frame.ray_y = {camera.up * half_height, 0.f};
  frame.light = {direction, light.ambient};
  frame.radiance = {light.color * light.intensity, 0.f};
  frame.liquid_color = {liquid, color_depth * stage_size};
  frame.liquid_absorption = {
      glm::log2(glm::max(liquid, glm::vec3(1e-3f))) / (color_depth * stage_size), 0.f};
  frame.gloss = {look.shininess, look.specular, 0.f, 0.f};
  frame.obstacle_color = {linear_from_srgb(look.obstacle_color), 0.f};
  frame.background_top = {linear_from_srgb(look.background_top), 0.f};
  frame.background_bottom = {linear_from_srgb(look.background_bottom), 0.f};
  frame.floor_color = {linear_from_srgb(look.floor_color), floor_reach * stage_size};
  frame.stage_min = {stage.min, 0.f};
  frame.stage_max = {stage.max, 0.f};
  frame.viewport = {width, height, 1.f / static_cast<float>(width),
                    1.f / static_cast<float>(height)};
  frame.depth_scale = {lens[2][2], lens[3][2], 0.f, 0.f};
  return frame;
}

}  // namespace spindrift::gl
