// Where the camera is at a time: keyframes, or a view that shows the whole domain.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/gl/renderer.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::app {

struct CameraKey {
  float time = 0.f;                   ///< s
  glm::vec3 position{0.f, 1.f, 4.f};  ///< m
  glm::vec3 target{0.f};              ///< m
  glm::vec3 up{0.f, 1.f, 0.f};        ///< need not be a unit vector
  float vertical_fov = 35.f;          ///< degrees
};

struct CameraSettings {
  std::vector<CameraKey> keyframes;  ///< in the order of their times; none: frame the domain
};

/// The view at a time. Between keys every component follows a monotone cubic (Fritsch & Carlson
/// 1980), which rests at the first and the last key and overshoots none; outside it is constant.
/// @param aspect width over height of the picture
gl::View view_at(const CameraSettings& camera, const sim::DomainSettings& domain, float aspect,
                 double time);

}  // namespace spindrift::app
