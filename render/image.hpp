// Defines the 8-bit picture that the renderer hands to the writers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spindrift {

/// 8-bit sRGB-encoded RGB picture, rows from top to bottom, three bytes per pixel, no padding.
struct Image {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  std::vector<std::uint8_t> pixels;

  Image() = default;
  /// Makes a black picture of w x h pixels.
  Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h * 3) {}
};

}  // namespace spindrift
