// What is drawn on: a multisampled sRGB picture and its resolved copy.
#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/image.hpp"

namespace spindrift::gl {

/// A picture with one sample per pixel, to be seen through the liquid.
class Behind {
 public:
  Behind(int width, int height);
  /// Makes it the target of what is drawn from now on.
  void bind() const;
  /// The same, with nothing on it.
  void begin() const;
  /// The picture's bytes: sRGB-encoded colours that are not decoded on reading.
  const TextureView& encoded() const { return encoded_; }

 private:
  int width_, height_;
  Texture picture_;
  TextureView encoded_;
  Renderbuffer depth_;
  Framebuffer target_;
};

class Canvas {
 public:
  /// @throws std::runtime_error when the driver cannot hold a picture of this size.
  Canvas(int width, int height);

  /// Makes the multisampled picture the target of what is drawn from now on.
  void bind() const;
  /// The same, with nothing on it. Its colours are left as they are: the backdrop covers them.
  void begin() const;
  /// Averages the samples in linear light and reads the picture back, top row first.
  Image read() const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_, height_;
  Renderbuffer samples_, depth_, resolved_;
  Framebuffer sampled_target_, resolved_target_;
};

}  // namespace spindrift::gl
