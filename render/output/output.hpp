// Declares the writers of pictures, videos and geometry, and the readers of pictures and videos.
// Every file that is written appears under its name only when it is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "render/frame_rate.hpp"
#include "render/image.hpp"
#include "render/mesh.hpp"

namespace spindrift::output {

/// Writes an 8-bit RGB PNG tagged sRGB.
/// @throws std::runtime_error naming the file and the reason, std::invalid_argument for an image
/// that is empty, too large for the encoder, or whose pixels do not fit its size
void write_png(const std::filesystem::path& file, const Image& image);

/// Returns the bytes of the PNG that write_png() writes.
/// @throws std::invalid_argument as write_png() does
std::vector<std::byte> encode_png(const Image& image);

/// Most pixels of a picture that is read: twice those of the largest picture that is drawn.
inline constexpr std::size_t most_pixels = std::size_t{2} * 8192 * 8192;

/// Reads a PNG as 8-bit RGB, without loss: grey is spread to three channels, a palette looked up. A
/// picture that 8-bit RGB cannot hold is refused: one that is transparent somewhere, that has
/// 16-bit samples between the 8-bit ones, or that is animated.
/// @throws std::runtime_error naming the file and the reason
Image read_png(const std::filesystem::path& file);

struct VideoSettings {
  int width = 1280;                  ///< pixels, even
  int height = 720;                  ///< pixels, even
  FrameRate frames_per_second = 30;  ///< more than 0, at most 1000
  int quality = 18;  ///< H.264 constant rate factor: 0 is best, 18 looks lossless, 51 is worst
};

/// Writes H.264 in MP4 that browsers play: profile High, yuv420p, BT.709 tagged, constant frame
/// rate, index at the front. Frames go in one by one; the file appears under its name on finish()
/// (or on destruction after at least one frame, so that an interrupted run leaves a video of what
/// was finished).
class VideoWriter {
 public:
  /// @throws std::invalid_argument for settings out of range, std::runtime_error when the encoder
  /// is missing or the file can't be written
  VideoWriter(const std::filesystem::path& file, const VideoSettings& settings);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Appends a frame.
  /// @throws std::invalid_argument for an image of another size (the video goes on without it),
  /// std::runtime_error when the file can't be written (the video is lost, and no file is left),
  /// std::logic_error after finish() or after a failure to write
  void add(const Image& image);

  /// Completes the file. A second call does nothing.
  /// @throws std::runtime_error as add() does, std::logic_error without a frame or after an error
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the number of pictures in a video, as its index says, or 0 where it cannot be read.
int video_length(const std::filesystem::path& file);

/// Decodes the pictures of a video one by one, to 8-bit sRGB-encoded RGB. (A still picture of a
/// format that libav knows is a video of one picture.) Pictures with more than 8 bits a sample, or
/// that are transparent somewhere, are refused. No other file is opened, whatever the video names.
class VideoReader {
 public:
  /// @throws std::runtime_error naming the file and the reason
  explicit VideoReader(const std::filesystem::path& file);
  ~VideoReader();
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;

  /// Returns the next picture, or none after the last.
  /// @throws std::runtime_error as the constructor does
  std::optional<Image> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the name of the H.264 encoder, and the versions of libavcodec and libavformat, for
/// reports.
std::string encoder_info();

/// Writes a triangle mesh as binary little-endian PLY: x y z [nx ny nz] of each vertex, then the
/// faces. Normals are one per vertex, or none.
/// @throws std::invalid_argument for another number of normals, and for more than 2^31 - 1
/// vertices; std::runtime_error naming the file and the reason
void write_ply(const std::filesystem::path& file, const Mesh& mesh);

/// Writes a triangle mesh as Wavefront OBJ: v, vn where there are normals, f. Numbers are written
/// with as many digits as it takes to read the same float back.
/// @throws std::invalid_argument for another number of normals than of vertices, std::runtime_error
/// naming the file and the reason
void write_obj(const std::filesystem::path& file, const Mesh& mesh);

/// The values of one attribute of all particles, in the same order for all attributes.
struct ParticleAttribute {
  std::string_view properties;  ///< names of its numbers, with a space between them
  std::string_view unit;        ///< in letters and digits; empty: it has none
  std::variant<std::vector<float>, std::vector<std::uint32_t>, std::vector<glm::vec3>> values;
};

/// Writes particles as binary little-endian PLY, with the properties of the attributes in their
/// order: floats, or unsigned integers of 32 bits.
/// @throws std::invalid_argument for attributes of unequal length, std::runtime_error naming the
/// file and the reason
void write_ply(const std::filesystem::path& file, std::span<const ParticleAttribute> attributes);

}  // namespace spindrift::output
