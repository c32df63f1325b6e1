#include "render/gl/passes/liquid_pass.hpp"

#include <array>

#include "shaders.hpp"

namespace spindrift::gl {

namespace {
constexpr std::array<float, 4> nothing{};
constexpr std::array<float, 4> far_away{1e30f, 0.f, 0.f, 0.f};
}  // namespace

LiquidPass::ObstacleRange::ObstacleRange(int width, int height)
    : program(make_program(shaders::surface_vert, shaders::range_frag)),
      range(make_texture(GL_R32F, width, height)) {
  glNamedRenderbufferStorage(depth, GL_DEPTH_COMPONENT24, width, height);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, range, 0);
  glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
}

void LiquidPass::ObstacleRange::measure(const MeshBuffers& obstacles) const {
  const float farthest = 1.f;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, far_away.data());
  glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
  glUseProgram(program);
  obstacles.draw();
}

LiquidPass::LiquidPass(int width, int height)
    : width_((width + 1) / 2),
      height_((height + 1) / 2),
      thickness_program_(make_program(shaders::surface_vert, shaders::thickness_frag)),
      liquid_normal_program_(make_program(shaders::surface_vert, shaders::normal_liquid_frag)),
      obstacle_normal_program_(make_program(shaders::obstacle_vert, shaders::normal_obstacle_frag)),
      shading_program_(make_program(shaders::tiles_vert, shaders::liquid_frag)),
      surfaces_(GL_RGBA8, width, height),
      thickness_(make_texture(GL_R32F, width_, height_)),
      no_obstacles_(make_texture(GL_R32F, 1, 1)) {
  glNamedFramebufferTexture(thickness_target_, GL_COLOR_ATTACHMENT0, thickness_, 0);
  glClearTexImage(no_obstacles_, 0, GL_RED, GL_FLOAT, far_away.data());
}

void LiquidPass::measure(const MeshBuffers& liquid, const MeshBuffers* obstacles) {
  glViewport(0, 0, width_, height_);
  if (obstacles) {
    if (!obstacle_range_)
      obstacle_range_.emplace(width_, height_);
    obstacle_range_->measure(*obstacles);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, thickness_target_);
  glClearNamedFramebufferfv(thickness_target_, GL_COLOR, 0, nothing.data());
  glBindTextureUnit(0, obstacles ? obstacle_range_->range : no_obstacles_);
  glUseProgram(thickness_program_);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  liquid.draw();
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

void LiquidPass::outline(const MeshBuffers& liquid, const MeshBuffers* obstacles,
                         bool above_floor) const {
  surfaces_.begin();
  glClear(GL_COLOR_BUFFER_BIT);
  if (obstacles) {
    glUseProgram(obstacle_normal_program_);
    if (above_floor)
      glEnable(GL_CLIP_DISTANCE0);
    obstacles->draw();
    glDisable(GL_CLIP_DISTANCE0);
  }
  glUseProgram(liquid_normal_program_);
  glEnable(GL_CULL_FACE);
  liquid.draw();
  glDisable(GL_CULL_FACE);
}

void LiquidPass::shade(const Picture& picture, const TextureView& behind, bool has_obstacles,
                       Tiles& tiles) const {
  picture.bind();
  glBindTextureUnit(0, thickness_);
  glBindTextureUnit(1, behind);
  glBindTextureUnit(2, surfaces_.values());
  glBindTextureUnit(3, surfaces_.depth());
  glUseProgram(shading_program_);
  glProgramUniform1i(shading_program_, 0, has_obstacles);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  tiles.draw();
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace spindrift::gl
