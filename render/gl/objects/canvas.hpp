// Owns what is drawn on: the finished picture, the picture behind the liquid, and multisampled
// buffers.
#pragma once

#include "render/gl/objects/gl_objects.hpp"
#include "render/image.hpp"

namespace spindrift::gl {

/// The finished picture: one sample per pixel, sRGB-encoded.
class Picture {
 public:
  /// @param width, height pixels
  /// @throws std::runtime_error when the driver cannot hold a picture of this size
  Picture(int width, int height);

  /// Makes this picture the target of what is drawn from now on.
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

/// The picture without the liquid, one sample per pixel, which is seen through the liquid.
class Behind {
 public:
  /// @param width, height pixels
  /// @throws std::runtime_error when the driver cannot hold a picture of this size
  Behind(int width, int height);
  /// Makes this a copy of `picture`, and the target of what is drawn from now on.
  void begin(const Picture& picture) const;
  /// The picture's bytes as a texture: sRGB-encoded colours that are not decoded on reading.
  const TextureView& encoded() const { return encoded_; }

 private:
  int width_, height_;
  Texture picture_;
  TextureView encoded_;
  Renderbuffer depth_;
  Framebuffer target_;
};

/// A multisampled target: four samples per pixel of a value, such as a colour, and of depth.
class Samples {
 public:
  /// @param format        OpenGL's internal format of the values
  /// @param width, height pixels
  /// @throws std::runtime_error when the driver cannot hold a picture of this size
  Samples(GLenum format, int width, int height);

  /// Makes these samples the target of what is drawn from now on. Their depth is cleared; their
  /// values are left as they are.
  void begin() const;
  /// Fills the picture with the average of each pixel's samples.
  void resolve(const Picture& picture) const;

  const MultisampleTexture& values() const { return values_; }
  const MultisampleTexture& depth() const { return depth_; }

 private:
  int width_, height_;
  MultisampleTexture values_, depth_;
  Framebuffer target_;
};

}  // namespace spindrift::gl
