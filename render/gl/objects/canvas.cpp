#include "render/gl/objects/canvas.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace spindrift::gl {

namespace {
constexpr int samples_per_pixel = 4;

void require_complete(const Framebuffer& target, int width, int height) {
  if (glCheckNamedFramebufferStatus(target, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(
        fmt::format("the OpenGL driver cannot draw a picture of {} x {} pixels", width, height));
  }
}
}  // namespace

Picture::Picture(int width, int height)
    : width_(width), height_(height), picture_(make_texture(GL_SRGB8_ALPHA8, width, height)) {
  glNamedFramebufferTexture(target_, GL_COLOR_ATTACHMENT0, picture_, 0);
  require_complete(target_, width, height);
}

void Picture::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  glViewport(0, 0, width_, height_);
}

Behind::Behind(int width, int height)
    : width_(width), height_(height), picture_(make_texture(GL_SRGB8_ALPHA8, width, height)) {
  glTextureView(encoded_, GL_TEXTURE_2D, picture_, GL_RGBA8, 0, 1, 0, 1);
  glTextureParameteri(encoded_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(encoded_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(encoded_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glNamedRenderbufferStorage(depth_, GL_DEPTH_COMPONENT24, width, height);
  glNamedFramebufferTexture(target_, GL_COLOR_ATTACHMENT0, picture_, 0);
  glNamedFramebufferRenderbuffer(target_, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  require_complete(target_, width, height);
}

void Behind::begin(const Picture& picture) const {
  glCopyImageSubData(picture.texture(), GL_TEXTURE_2D, 0, 0, 0, 0, picture_, GL_TEXTURE_2D, 0, 0, 0,
                     0, width_, height_, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  glViewport(0, 0, width_, height_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

Samples::Samples(GLenum format, int width, int height) : width_(width), height_(height) {
  glTextureStorage2DMultisample(values_, samples_per_pixel, format, width, height, GL_TRUE);
  glTextureStorage2DMultisample(depth_, samples_per_pixel, GL_DEPTH_COMPONENT24, width, height,
                                GL_TRUE);
  glNamedFramebufferTexture(target_, GL_COLOR_ATTACHMENT0, values_, 0);
  glNamedFramebufferTexture(target_, GL_DEPTH_ATTACHMENT, depth_, 0);
  require_complete(target_, width, height);
}

void Samples::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  glViewport(0, 0, width_, height_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void Samples::resolve(const Picture& picture) const {
  glBlitNamedFramebuffer(target_, picture.target(), 0, 0, width_, height_, 0, 0, width_, height_,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image Picture::read() const {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  std::vector<std::uint8_t> rgba(4 * pixels);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image(width_, height_);
  std::uint8_t* out = image.pixels.data();
  for (int y = height_ - 1; y >= 0; --y) {
    const std::uint8_t* in =
        rgba.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    for (int x = 0; x < width_; ++x, in += 4, out += 3) {
      out[0] = in[0];
      out[1] = in[1];
      out[2] = in[2];
    }
  }
  return image;
}

}  // namespace spindrift::gl
