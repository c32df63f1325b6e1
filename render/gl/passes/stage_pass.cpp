#include "render/gl/passes/stage_pass.hpp"

#include <algorithm>
#include <array>

#include "shaders.hpp"

namespace spindrift::gl {

namespace {

/// Draws one triangle that covers the whole picture.
void fill_picture(const Program& program, const VertexArray& no_attributes) {
  glUseProgram(program);
  glBindVertexArray(no_attributes);
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

/// A rectangle of pixels, from `low` up to, but not including, `high`.
struct Part {
  glm::ivec2 low, high;
};

/// Returns the part of the picture where an area of the floor may be seen.
Part part_of_picture(const ShadowArea& area, const FrameUniforms& frame, glm::ivec2 size) {
  const Part all{{0, 0}, size};
  Part part{size, {0, 0}};
  for (int i = 0; i < 4; ++i) {
    const glm::vec4 corner((i & 1) ? area.max.x : area.min.x, frame.stage_min.y,
                           (i & 2) ? area.max.y : area.min.y, 1.f);
    const glm::vec4 clip = frame.world_to_clip * corner;
    if (clip.z <= -clip.w)
      return all;  // the area reaches behind the eye
    const glm::vec2 place = glm::clamp(0.5f + 0.5f * glm::vec2(clip) / clip.w, 0.f, 1.f);
    const glm::ivec2 pixel(place * glm::vec2(size));
    part.low = glm::min(part.low, pixel - 1);
    part.high = glm::max(part.high, pixel + 2);
  }
  return {glm::max(part.low, 0), glm::min(part.high, size)};
}

void copy_texture(const Texture& from, const Texture& to, glm::ivec2 size) {
  glCopyImageSubData(from, GL_TEXTURE_2D, 0, 0, 0, 0, to, GL_TEXTURE_2D, 0, 0, 0, 0, size.x, size.y,
                     1);
}

}  // namespace

Surroundings::Surroundings(bool floor)
    : program_(make_program(shaders::fullscreen_vert,
                            floor ? shaders::floor_frag : shaders::background_frag)),
      no_shadow_(make_texture(GL_RGBA8, 1, 1)) {
  const std::array<float, 4> white{1.f, 1.f, 1.f, 1.f};
  glClearTexImage(no_shadow_, 0, GL_RGBA, GL_FLOAT, white.data());
}

void Surroundings::draw(const Texture* shadow) const {
  glBindTextureUnit(0, shadow ? *shadow : no_shadow_);
  fill_picture(program_, no_attributes_);
}

void Surroundings::draw_on(const Picture& picture, const FrameUniforms& frame,
                           const Texture* shadow, const ShadowArea& area) {
  picture.bind();
  if (last_ != frame) {
    last_ = frame;
    kept_.reset();
    draw(shadow);
    return;
  }
  const glm::ivec2 size(picture.width(), picture.height());
  if (kept_) {
    copy_texture(*kept_, picture.texture(), size);
  } else {
    draw(nullptr);
    kept_ = make_texture(GL_SRGB8_ALPHA8, size.x, size.y);
    copy_texture(picture.texture(), *kept_, size);
  }
  if (shadow) {
    const Part part = part_of_picture(area, frame, size);
    glScissor(part.low.x, part.low.y, std::max(part.high.x - part.low.x, 0),
              std::max(part.high.y - part.low.y, 0));
    glEnable(GL_SCISSOR_TEST);
    draw(shadow);
    glDisable(GL_SCISSOR_TEST);
  }
}

Edges::Edges() : program_(make_program(shaders::edges_vert, shaders::edges_frag)) {}

void Edges::draw(const MultisampleTexture& depth) const {
  glBindTextureUnit(0, depth);
  glUseProgram(program_);
  glBindVertexArray(no_attributes_);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 12);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace spindrift::gl
