// The camera of a scene: a path given by keyframes, or a view that shows the whole domain.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/gl/look/look.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::app {

/// The view at one moment of the camera's path.
struct CameraKey {
  float time = 0.f;                   ///< s
  glm::vec3 position{0.f, 1.f, 4.f};  ///< m
  glm::vec3 target{0.f};              ///< the point in the centre of the picture, m
  glm::vec3 up{0.f, 1.f, 0.f};        ///< need not be a unit vector
  float vertical_fov = 35.f;          ///< degrees
};

struct CameraSettings {
  std::vector<CameraKey> keyframes;  ///< in the order of their times; if empty, the whole domain
                                     ///< is shown
};

/// The view at a time, s. Between keys every component follows a monotone cubic (Fritsch & Carlson
/// 1980), which is at rest at the first and the last key and overshoots none; before the first and
/// after the last key the view is constant.
/// @param aspect width of the picture over its height
gl::View view_at(const CameraSettings& camera, const sim::DomainSettings& domain, float aspect,
                 double time);

}  // namespace spindrift::app
