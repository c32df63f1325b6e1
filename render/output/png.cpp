// Writes and reads PNG through stb: stb filters the rows and lays out the file, libdeflate
// compresses it (many times faster than stb's own compressor, and smaller). stb writes no colour
// tag, so it is put in here.

#include <libdeflate.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "render/output/atomic_file.hpp"
#include "render/output/input_file.hpp"
#include "render/output/output.hpp"

namespace {

// Time of a whole write_png() and size of the file, measured on a water-like frame of 1280x720
// pixels with one core of a 2021 Xeon:
//   filter "up":      level 1: 10 ms, 430 KiB   level 3: 15 ms, 407 KiB   level 6: 32 ms, 388 KiB
//   filter "sub":     level 1: 11 ms, 439 KiB
//   filter "Paeth":   level 1: 13 ms, 435 KiB
//   best of all five: level 1: 17 ms, 435 KiB
constexpr int filter_up = 2;
constexpr int compression_level = 1;

// Compresses data for stb, which takes over the result and frees it with free().
unsigned char* deflate_for_stb(const unsigned char* data, int size, int* compressed_size,
                               int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(compression_level), &libdeflate_free_compressor);
  if (!compressor)
    return nullptr;
  const auto length = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), length);
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (out != nullptr) {
    *compressed_size =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, length, out, bound));
  }
  return out;
}

unsigned int crc32_for_stb(const unsigned char* data, int size) {
  return libdeflate_crc32(0, data, static_cast<std::size_t>(size));
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflate_for_stb
#define STBIW_CRC32 crc32_for_stb
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace spindrift::output {
namespace {

using Bytes = std::vector<std::byte>;

// The colour tag follows the signature (8 bytes) and the IHDR chunk (4 length, 4 type, 13 data,
// 4 checksum).
constexpr std::size_t bytes_before_colour_tag = 8 + 4 + 4 + 13 + 4;

// Returns an sRGB chunk: length 1, type, intent 0 (perceptual), checksum of type and data.
std::array<std::byte, 13> srgb_chunk() {
  std::array<unsigned char, 13> chunk = {0, 0, 0, 1, 's', 'R', 'G', 'B', 0};
  const std::uint32_t checksum = libdeflate_crc32(0, chunk.data() + 4, 5);
  for (std::size_t i = 0; i < 4; ++i)
    chunk[9 + i] = static_cast<unsigned char>(checksum >> (24 - 8 * i));
  return std::bit_cast<std::array<std::byte, 13>>(chunk);
}

/// Returns the PNG as stb lays it out, without the colour tag.
Bytes encode(const Image& image) {
  // The filter is set once, before its first use; stb takes it from a global of this file.
  [[maybe_unused]] static const int filter = stbi_write_force_png_filter = filter_up;
  Bytes png;
  const auto take = [](void* context, void* data, int size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    static_cast<Bytes*>(context)->assign(bytes, bytes + size);
  };
  if (stbi_write_png_to_func(take, &png, image.width, image.height, 3, image.pixels.data(), 0) ==
          0 ||
      png.size() < bytes_before_colour_tag)
    throw std::bad_alloc();
  return png;
}

/// Returns the number that is stored in four bytes, big-endian, as all numbers in PNG are.
std::uint32_t number_at(std::string_view png, std::size_t place) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | static_cast<unsigned char>(png[place + i]);
  return number;
}

/// A chunk of a PNG. As a whole it is a length (4 bytes), a type (4), data and a checksum (4).
struct Chunk {
  std::string_view type, whole;
};

constexpr std::size_t signature = 8, chunk_without_data = 12;  // bytes

/// Calls `look` with each chunk, up to and including one that is cut off by the end of the file.
template <class Look>
void for_each_chunk(std::string_view png, const Look& look) {
  for (std::size_t at = signature; at + chunk_without_data <= png.size();) {
    const std::size_t bytes = chunk_without_data + number_at(png, at);
    look(Chunk{png.substr(at + 4, 4), png.substr(at, bytes)});
    at += bytes;
  }
}

bool has_chunk(std::string_view png, std::string_view type) {
  bool found = false;
  for_each_chunk(png, [&](const Chunk& chunk) { found = found || chunk.type == type; });
  return found;
}

/// Returns the PNG without those chunks of pixels (IDAT) that hold no data, which PNG allows. For
/// such chunks before the first with data, stb copies zero bytes to a null pointer, which C++
/// leaves undefined.
std::string without_empty_pixel_chunks(std::string_view png) {
  std::string kept(png.substr(0, signature));
  kept.reserve(png.size());
  for_each_chunk(png, [&](const Chunk& chunk) {
    if (chunk.type != "IDAT" || chunk.whole.size() > chunk_without_data)
      kept += chunk.whole;
  });
  return kept;
}

/// Returns the reason for which a PNG is refused before memory is taken for its pixels, or an empty
/// text: there are more pixels than are accepted or than the file can hold, or a chunk is longer
/// than the file.
std::string why_refused(std::string_view png) {
  // Byte offsets of IHDR's values in the file, and the number of channels of each colour type.
  constexpr std::size_t width_at = 16, height_at = 20, depth_at = 24, colour_type_at = 25;
  constexpr std::array<std::uint64_t, 7> channels_by_type = {1, 0, 3, 1, 2, 0, 4};
  constexpr std::uint64_t most_per_byte = 1032;  // most bytes that one byte can be inflated to
  if (png.size() < bytes_before_colour_tag || png.substr(12, 4) != "IHDR")
    return "it does not begin as a PNG does";
  const std::uint64_t width = number_at(png, width_at), height = number_at(png, height_at);
  if (width == 0 || height == 0 || width > most_pixels || height > most_pixels ||
      width * height > most_pixels) {
    return std::to_string(width) + "x" + std::to_string(height) + " pixels; accepted: 1 to " +
           std::to_string(most_pixels) + " in all";
  }
  const auto colours = static_cast<unsigned char>(png[colour_type_at]);
  const std::uint64_t bits = static_cast<unsigned char>(png[depth_at]) *
                             (colours < channels_by_type.size() ? channels_by_type[colours] : 0);
  // A file without its last chunk, IEND, ends within another chunk, whose length is too large.
  return !has_chunk(png, "IEND") || width * height * bits / 8 > most_per_byte * png.size()
             ? "damaged or cut short"
             : "";
}

struct FreePixels {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <class Sample>
using Pixels = std::unique_ptr<Sample, FreePixels>;

std::size_t samples(const Image& image, int channels) {
  return std::size_t(image.width) * std::size_t(image.height) * std::size_t(channels);
}

}  // namespace

Bytes encode_png(const Image& image) {
  constexpr std::size_t largest = std::numeric_limits<int>::max() / 2;  // stb counts in int
  if (image.width <= 0 || image.height <= 0 ||
      image.pixels.size() != std::size_t(image.width) * std::size_t(image.height) * 3 ||
      image.pixels.size() > largest) {
    throw std::invalid_argument("PNG: bad image of " + std::to_string(image.width) + "x" +
                                std::to_string(image.height) + " pixels");
  }
  Bytes png = encode(image);
  const auto tag = srgb_chunk();
  png.insert(png.begin() + bytes_before_colour_tag, tag.begin(), tag.end());
  return png;
}

void write_png(const std::filesystem::path& file, const Image& image) {
  const Bytes png = encode_png(image);
  AtomicFile output(file);
  output.write(png);
  output.commit();
}

Image read_png(const std::filesystem::path& file) {
  std::string png = read_file(file);
  const auto fail = [&](const std::string& reason) {
    throw std::runtime_error("cannot read " + file.string() + ": " + reason);
  };
  if (png.size() > std::numeric_limits<int>::max())
    fail("file too large");
  if (const std::string reason = why_refused(png); !reason.empty())
    fail(reason);
  png = without_empty_pixel_chunks(png);
  const auto* bytes = reinterpret_cast<const stbi_uc*>(png.data());
  const int length = static_cast<int>(png.size());
  if (has_chunk(png, "acTL"))
    fail("it is animated; accepted: still pictures");
  Image image;
  int channels = 0;
  const auto require = [&](const void* pixels) {
    if (pixels == nullptr) {
      const char* reason = stbi_failure_reason();
      fail("damaged, cut short or no picture (" + std::string(reason ? reason : "no reason given") +
           ")");
    }
  };
  const bool plain = stbi_info_from_memory(bytes, length, &image.width, &image.height, &channels) &&
                     channels % 2 == 1 && !has_chunk(png, "tRNS") &&
                     !stbi_is_16_bit_from_memory(bytes, length);
  if (plain) {
    const Pixels<stbi_uc> pixels(
        stbi_load_from_memory(bytes, length, &image.width, &image.height, &channels, 3));
    require(pixels.get());
    image.pixels.assign(pixels.get(), pixels.get() + samples(image, 3));
    return image;
  }
  const Pixels<stbi_us> pixels(
      stbi_load_16_from_memory(bytes, length, &image.width, &image.height, &channels, 4));
  require(pixels.get());
  image.pixels.reserve(samples(image, 3));
  for (std::size_t i = 0; i < samples(image, 4); ++i) {
    const stbi_us sample = pixels.get()[i];
    if (i % 4 == 3) {
      if (sample != 0xffff)
        fail("it is transparent in places; accepted: opaque pictures");
      continue;
    }
    if (sample % 0x101 != 0)  // an 8-bit value v is v * 0x101 in 16 bits
      fail("it has 16-bit samples that 8 bits cannot hold; accepted: 8 bits a sample");
    image.pixels.push_back(static_cast<std::uint8_t>(sample >> 8));
  }
  return image;
}

}  // namespace spindrift::output
