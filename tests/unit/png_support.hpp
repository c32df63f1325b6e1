// PNG files of every kind, by their definition (W3C, "Portable Network Graphics", third edition).
#pragma once

#include <cstdint>
#include <string>

namespace spindrift::output_test {

enum class PngColour { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgb_alpha = 6 };

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> shift);
  return bytes;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  std::uint32_t checksum = ~0u;
  for (const char c : type + data) {
    checksum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      checksum = checksum >> 1 ^ (checksum & 1 ? 0xedb88320u : 0u);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~checksum);
}

/// A picture of one row.
/// @param samples the row's bytes as the file has them
/// @param before chunks between the header and the pixels
inline std::string one_row_png(PngColour colour, int depth, std::uint32_t width,
                               const std::string& samples, const std::string& before = "") {
  const std::string row = '\0' + samples;  // without a filter
  std::uint32_t a = 1, b = 0;
  for (const char c : row) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(row.size());
  const auto little = [](unsigned value) {
    return std::string{static_cast<char>(value), static_cast<char>(value >> 8)};
  };
  const std::string stored = std::string("\x78\x01\x01", 3) + little(size) +
                             little(static_cast<std::uint16_t>(~size)) + row +
                             big_endian(b << 16 | a);
  const std::string header = big_endian(width) + big_endian(1) + static_cast<char>(depth) +
                             static_cast<char>(colour) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + before + png_chunk("IDAT", stored) +
         png_chunk("IEND", "");
}

}  // namespace spindrift::output_test
