#include "render/gl/passes/particle_pass.hpp"

#include "shaders.hpp"

namespace spindrift::gl {

ParticlePass::ParticlePass() : program_(make_program(shaders::sphere_vert, shaders::sphere_frag)) {}

void ParticlePass::draw(const ParticleBuffers& particles, float low, float high) const {
  glUseProgram(program_);
  glProgramUniform3f(program_, 0, particles.radius(), low, high);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  particles.draw();
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

}  // namespace spindrift::gl
