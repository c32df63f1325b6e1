#include "render/gl/passes/shadow_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "shaders.hpp"

namespace spindrift::gl {

namespace {

constexpr int longer_side = 208;  // texels; few, since the lamp is wide and the blur reaches far

int texels(float side, float longer) {
  return std::max(16, static_cast<int>(std::ceil(longer_side * side / longer)));
}

float longer(const ShadowArea& area) {
  return std::max(area.max.x - area.min.x, area.max.y - area.min.y);
}

}  // namespace

ShadowPass::Target::Target(GLenum format, int width, int height)
    : texture(make_texture(format, width, height)) {
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
}

ShadowPass::ShadowPass(const ShadowArea& area, glm::vec3 light, float floor)
    : width_(texels(area.max.x - area.min.x, longer(area))),
      height_(texels(area.max.y - area.min.y, longer(area))),
      blocked_(GL_R32F, width_, height_),
      half_blurred_(GL_RGBA8, width_, height_),
      arriving_(GL_RGBA8, width_, height_),
      blur_(make_program(shaders::fullscreen_vert, shaders::shadow_blur_frag)),
      splat_(width_, height_, world_to_shadow(light, floor, area), light, floor) {}

void ShadowPass::begin(const Mesh* liquid) {
  glBindFramebuffer(GL_FRAMEBUFFER, blocked_.framebuffer);
  glViewport(0, 0, width_, height_);
  if (liquid) {
    glTextureSubImage2D(blocked_.texture, 0, 0, 0, width_, height_, GL_RED, GL_FLOAT,
                        splat_.measure(*liquid).data());
  } else {
    const std::array<float, 4> nothing{};
    glClearNamedFramebufferfv(blocked_.framebuffer, GL_COLOR, 0, nothing.data());
  }
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

void ShadowPass::add_particles(const ParticleBuffers& particles) {
  if (!sphere_)
    sphere_ = make_program(shaders::shadow_sphere_vert, shaders::shadow_sphere_frag);
  glUseProgram(*sphere_);
  glProgramUniform1f(*sphere_, 0, particles.radius());
  particles.draw();
}

void ShadowPass::add_obstacles(const MeshBuffers& obstacles) {
  if (!solid_)
    solid_ = make_program(shaders::shadow_mesh_vert, shaders::shadow_solid_frag);
  glUseProgram(*solid_);
  obstacles.draw();
}

const Texture& ShadowPass::finish() const {
  glDisable(GL_BLEND);
  glUseProgram(blur_);
  glBindVertexArray(no_attributes_);
  const auto blur = [&](const Target& from, const Target& to, int dx, int dy, bool first) {
    glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
    glBindTextureUnit(0, from.texture);
    glProgramUniform2i(blur_, 0, dx, dy);
    glProgramUniform1i(blur_, 1, first);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  };
  blur(blocked_, half_blurred_, 1, 0, true);
  blur(half_blurred_, arriving_, 0, 1, false);
  glEnable(GL_DEPTH_TEST);
  return arriving_.texture;
}

}  // namespace spindrift::gl
