#include "app/scene/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/geometry/keyframes.hpp"

namespace spindrift::app {
namespace {

constexpr float automatic_fov = 35.f;      // degrees
constexpr float automatic_margin = 0.06f;  // left free on every side, as a part of half the picture
const glm::vec3 automatic_direction{0.38f, 0.40f, 1.f};  // from the domain to the camera

/// A three-quarter view of a box from slightly above, as near as all eight corners allow. With the
/// camera at (cx, cy, cz) in its own axes, corner (x, y, z) is inside the picture when
/// |x − cx| ≤ tx (cz − z). The largest values of x + tx z and of −x + tx z over the corners
/// therefore give cx and the least cz; the same holds for y with ty.
gl::View frame_box(const glm::vec3& box_min, const glm::vec3& box_max, float aspect) {
  const glm::vec3 back = glm::normalize(automatic_direction);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3{0.f, 1.f, 0.f}, back));
  const glm::vec3 up = glm::cross(back, right);
  const float inner = 1.f - automatic_margin;
  const float ty = std::tan(glm::radians(automatic_fov) / 2.f) * inner;
  const float tx = ty * aspect;
  const glm::vec3 center = 0.5f * (box_min + box_max);

  float left_most = -1e30f, right_most = -1e30f, low_most = -1e30f, high_most = -1e30f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p =
        glm::vec3{(corner & 1) ? box_max.x : box_min.x, (corner & 2) ? box_max.y : box_min.y,
                  (corner & 4) ? box_max.z : box_min.z} -
        center;
    const float x = glm::dot(p, right), y = glm::dot(p, up), z = glm::dot(p, back);
    right_most = std::max(right_most, x + tx * z);
    left_most = std::max(left_most, -x + tx * z);
    high_most = std::max(high_most, y + ty * z);
    low_most = std::max(low_most, -y + ty * z);
  }
  const float distance =
      std::max((right_most + left_most) / (2.f * tx), (high_most + low_most) / (2.f * ty));
  const glm::vec3 target =
      center + 0.5f * (right_most - left_most) * right + 0.5f * (high_most - low_most) * up;

  gl::View view;
  view.position = target + distance * back;
  view.target = target;
  view.up = glm::vec3{0.f, 1.f, 0.f};
  view.vertical_fov = automatic_fov;
  return view;
}

/// The numbers of a camera key as an array, so that one loop interpolates them all.
using Numbers = std::array<float, 10>;

Numbers numbers_of(const CameraKey& k) {
  const glm::vec3 up = glm::normalize(k.up);
  return {k.position.x, k.position.y, k.position.z, k.target.x, k.target.y,
          k.target.z,   up.x,         up.y,         up.z,       k.vertical_fov};
}

gl::View view_of(const Numbers& n) {
  gl::View view;
  view.position = {n[0], n[1], n[2]};
  view.target = {n[3], n[4], n[5]};
  view.up = {n[6], n[7], n[8]};
  view.vertical_fov = n[9];
  return view;
}

}  // namespace

gl::View view_at(const CameraSettings& camera, const sim::DomainSettings& domain, float aspect,
                 double time) {
  const auto& keys = camera.keyframes;
  if (keys.empty())
    return frame_box(domain.min, domain.max, aspect);
  const auto numbers = sim::numbers_at(keys, time, numbers_of, false);
  Numbers result{};
  for (std::size_t c = 0; c < result.size(); ++c)
    result[c] = static_cast<float>(numbers[c]);
  return view_of(result);
}

}  // namespace spindrift::app
