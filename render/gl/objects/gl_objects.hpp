// Defines owners of OpenGL objects, and makes textures and programs. Each owner deletes its object
// when it is destroyed; the context must be current then.
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace spindrift::gl {

/// Owns the name of one OpenGL object. `Kind` says how the object is created and destroyed.
template <typename Kind>
class Handle {
 public:
  Handle() requires requires { Kind::create(); } : id_(Kind::create()) {
  }
  explicit Handle(GLenum target) requires requires {
    Kind::create(target);
  } : id_(Kind::create(target)) {
  }
  ~Handle() {
    if (id_ != 0)
      Kind::destroy(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  // OpenGL's functions take names. NOLINTNEXTLINE(google-explicit-constructor)
  operator GLuint() const { return id_; }

 private:
  GLuint id_;
};

struct BufferKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};

struct VertexArrayKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};

struct TextureKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};

struct MultisampleTextureKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};

/// Only the name is created here; glTextureView then makes the texture.
struct TextureViewKind {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};

struct RenderbufferKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

struct FramebufferKind {
  static GLuint create() {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

struct ShaderKind {
  static GLuint create(GLenum stage) { return glCreateShader(stage); }
  static void destroy(GLuint id) { glDeleteShader(id); }
};

struct ProgramKind {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using Buffer = Handle<BufferKind>;
using VertexArray = Handle<VertexArrayKind>;
using Texture = Handle<TextureKind>;
using MultisampleTexture = Handle<MultisampleTextureKind>;
using TextureView = Handle<TextureViewKind>;
using Renderbuffer = Handle<RenderbufferKind>;
using Framebuffer = Handle<FramebufferKind>;
using Shader = Handle<ShaderKind>;
using Program = Handle<ProgramKind>;

/// Replaces the contents of a buffer.
template <typename T>
void upload(const Buffer& buffer, std::span<const T> values) {
  glNamedBufferData(buffer, static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                    GL_STREAM_DRAW);
}

/// Makes a texture with one level, filtered linearly, clamped at its edges.
/// @param format        OpenGL's internal format
/// @param width, height texels
Texture make_texture(GLenum format, int width, int height);

/// One GLSL file as it was embedded at build time.
struct ShaderFile {
  std::string_view name;  ///< file name in shaders/
  std::string_view text;
};

/// Compiles and links a vertex and a fragment shader, each behind shaders/common.glsl.
/// @throws std::runtime_error with the files' names and the compiler's or linker's log
Program make_program(const ShaderFile& vertex, const ShaderFile& fragment);

}  // namespace spindrift::gl
