// What is drawn on: the picture, the picture behind the liquid, and multisampled buffers.
#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/image.hpp"

namespace spindrift::gl {

/// The finished picture: one sample per pixel, sRGB-encoded.
class Picture {
 public:
  /// @throws std::runtime_error when the driver cannot hold a picture of this size.
  Picture(int width, int height);

  /// Makes it the target of what is drawn from now on.
  void bind() const;
  /// Reads the picture back, top row first.
  Image read() const;

  int width() const { return width_; }
  int height() const { return height_; }
  const Texture& texture() const { return picture_; }
  const Framebuffer& target() const { return target_; }

 private:
  int width_, height_;
  Texture picture_;
  Framebuffer target_;
};

/// The picture without the liquid, one sample per pixel, to be seen through the liquid.
class Behind {
 public:
  Behind(int width, int height);
  /// Starts it as a copy of `picture` and makes it the target of what is drawn from now on.
  void begin(const Picture& picture) const;
  /// The picture's bytes: sRGB-encoded colours that are not decoded on reading.
  const TextureView& encoded() const { return encoded_; }

 private:
  int width_, height_;
  Texture picture_;
  TextureView encoded_;
  Renderbuffer depth_;
  Framebuffer target_;
};

/// Four samples per pixel of something and of its depth.
class Samples {
 public:
  /// @throws std::runtime_error when the driver cannot hold a picture of this size.
  Samples(GLenum format, int width, int height);

  /// Makes them the target of what is drawn from now on, with nothing on them. The colours are left
  /// as they are.
  void begin() const;
  /// Fills the picture with the averages.
  void resolve(const Picture& picture) const;

  const MultisampleTexture& values() const { return values_; }
  const MultisampleTexture& depth() const { return depth_; }

 private:
  int width_, height_;
  MultisampleTexture values_, depth_;
  Framebuffer target_;
};

}  // namespace spindrift::gl
