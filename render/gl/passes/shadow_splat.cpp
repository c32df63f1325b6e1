#include "render/gl/passes/shadow_splat.hpp"

#include <algorithm>

namespace spindrift::gl {

namespace {
constexpr float longest = 1.5f;  ///< texels; sides longer than this are divided
}  // namespace

ShadowSplat::ShadowSplat(int width, int height, const glm::mat4& world_to_shadow, glm::vec3 light,
                         float floor)
    : width_(width), height_(height), to_texels_(0.f) {
  const glm::vec2 half(0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height));
  for (int i = 0; i < 4; ++i)
    to_texels_[i] = {half * glm::vec2(world_to_shadow[i]), 0.f, 0.f};
  to_texels_[3] += glm::vec4(half - 0.5f, floor / light.y, 1.f);
  to_texels_[1].z = -1.f / light.y;
}

const std::vector<float>& ShadowSplat::measure(const Mesh& liquid) {
  blocked_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.f);
  places_.resize(liquid.vertices.size());
  std::ranges::transform(liquid.vertices, places_.begin(), [&](const glm::vec3& vertex) {
    return glm::vec3(to_texels_ * glm::vec4(vertex, 1.f));
  });
  for (const glm::uvec3& t : liquid.triangles)
    add(places_[t.x], places_[t.y], places_[t.z]);
  return blocked_;
}

void ShadowSplat::add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::vec2 size = glm::max(glm::max(glm::vec2(a), glm::vec2(b)), glm::vec2(c)) -
                         glm::min(glm::min(glm::vec2(a), glm::vec2(b)), glm::vec2(c));
  if (std::max(size.x, size.y) > longest) {
    const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
    add(a, ab, ca);
    add(ab, b, bc);
    add(ca, bc, c);
    add(ab, bc, ca);
    return;
  }
  // Triangles through which the light enters the liquid add their way to the floor, triangles
  // through which it leaves subtract it.
  const glm::vec3 middle = (a + b + c) / 3.f;
  const float area = 0.5f * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const float amount = area * middle.z;
  if (!(middle.x >= 0.f && middle.y >= 0.f && middle.x < static_cast<float>(width_ - 1) &&
        middle.y < static_cast<float>(height_ - 1)))
    return;  // the triangle lies outside the map
  const int x = static_cast<int>(middle.x), y = static_cast<int>(middle.y);
  const float right = amount * (middle.x - static_cast<float>(x)), left = amount - right;
  const float up = middle.y - static_cast<float>(y), down = 1.f - up;
  float* const below = &blocked_[static_cast<std::size_t>(y) * width_ + x];
  float* const above = below + width_;
  below[0] += down * left;
  below[1] += down * right;
  above[0] += up * left;
  above[1] += up * right;
}

}  // namespace spindrift::gl
