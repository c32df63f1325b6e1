#include "render/gl/objects/gl_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "shaders.hpp"

namespace spindrift::gl {

namespace {

Shader compile(GLenum stage, const ShaderFile& file) {
  // Lines are counted anew in each part, so that a log's line numbers are those of the files.
  const std::array<std::string_view, 4> parts = {
      "#version 450 core\n#line 1 1\n", shaders::common_glsl.text, "\n#line 1 0\n", file.text};
  std::array<const GLchar*, parts.size()> texts;
  std::array<GLint, parts.size()> sizes;
  std::ranges::transform(parts, texts.begin(), [](auto part) { return part.data(); });
  std::ranges::transform(parts, sizes.begin(),
                         [](auto part) { return static_cast<GLint>(part.size()); });
  Shader shader(stage);
  glShaderSource(shader, static_cast<GLsizei>(parts.size()), texts.data(), sizes.data());
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw std::runtime_error(fmt::format(
        "shaders/{} (source 0; common.glsl is source 1) does not compile: {}", file.name, log));
  }
  return shader;
}

}  // namespace

Texture make_texture(GLenum format, int width, int height) {
  Texture texture;
  glTextureStorage2D(texture, 1, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

Program make_program(const ShaderFile& vertex, const ShaderFile& fragment) {
  const Shader vertex_shader = compile(GL_VERTEX_SHADER, vertex);
  const Shader fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
  Program program;
  glAttachShader(program, vertex_shader);
  glAttachShader(program, fragment_shader);
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (!good) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw std::runtime_error(
        fmt::format("shaders/{} and shaders/{} do not link: {}", vertex.name, fragment.name, log));
  }
  return program;
}

}  // namespace spindrift::gl
