#include "render/gl/objects/tiles.hpp"

#include <algorithm>

namespace spindrift::gl {

namespace {
constexpr int tile_size = 16;  // of a tile, pixels
}  // namespace

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + tile_size - 1) / tile_size),
      rows_((height + tile_size - 1) / tile_size),
      touched_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
  glVertexArrayVertexBuffer(array_, 0, buffer_, 0, sizeof(glm::vec2));
  glVertexArrayAttribFormat(array_, 0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array_, 0, 0);
  glEnableVertexArrayAttrib(array_, 0);
}

void Tiles::clear() {
  std::ranges::fill(touched_, static_cast<unsigned char>(0));
}

void Tiles::add(const Mesh& mesh, const glm::mat4& world_to_clip) {
  const glm::vec2 half = 0.5f / static_cast<float>(tile_size) * glm::vec2(width_, height_);
  const glm::vec2 limit(columns_, rows_);
  bool before_eye = true;
  places_.resize(mesh.vertices.size());
  std::ranges::transform(mesh.vertices, places_.begin(), [&](const glm::vec3& vertex) {
    const glm::vec4 clip = world_to_clip * glm::vec4(vertex, 1.f);
    before_eye = before_eye && clip.w > 0.f && clip.z > -clip.w;
    const glm::vec2 place = half * (1.f + glm::vec2(clip) / clip.w);
    return glm::ivec2(glm::clamp(place, glm::vec2(-1.f), limit) + 1.f) - 1;
  });
  if (!before_eye) {
    std::ranges::fill(touched_, static_cast<unsigned char>(1));
    return;
  }
  const glm::ivec2 last(columns_ - 1, rows_ - 1);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::ivec2 a = places_[t.x], b = places_[t.y], c = places_[t.z];
    const glm::ivec2 low = glm::max(glm::min(a, glm::min(b, c)), 0);
    const glm::ivec2 high = glm::min(glm::max(a, glm::max(b, c)), last);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        touched_[static_cast<std::size_t>(y) * columns_ + x] = 1;
  }
}

void Tiles::draw() {
  corners_.clear();
  const glm::vec2 scale = 2.f * static_cast<float>(tile_size) / glm::vec2(width_, height_);
  for (int y = 0; y < rows_; ++y) {
    const auto row = touched_.begin() + y * columns_, end = row + columns_;
    for (auto from = std::find(row, end, 1); from != end;) {
      const auto to = std::find(from, end, 0);
      const glm::vec2 low = scale * glm::vec2(from - row, y) - 1.f;
      const glm::vec2 high = scale * glm::vec2(to - row, y + 1) - 1.f;
      corners_.insert(corners_.end(), {low, {high.x, low.y}, high, low, high, {low.x, high.y}});
      from = std::find(to, end, 1);
    }
  }
  upload(buffer_, std::span<const glm::vec2>(corners_));
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
}

}  // namespace spindrift::gl
