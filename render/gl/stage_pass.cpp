#include "render/gl/stage_pass.hpp"

#include <array>

#include "shaders.hpp"

namespace spindrift::gl {

namespace {

/// A triangle over the whole picture.
void fill_picture(const Program& program, const VertexArray& no_attributes) {
  glUseProgram(program);
  glBindVertexArray(no_attributes);
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
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
