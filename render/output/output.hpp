// Writers for pictures, videos and geometry. Every file appears under its name only when complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/frame_rate.hpp"
#include "render/image.hpp"
#include "render/mesh.hpp"

namespace spindrift::output {

/// Writes an 8-bit RGB PNG tagged sRGB. @throws std::runtime_error naming the file and the reason,
/// std::invalid_argument for an empty image or one whose pixels do not fit its size.
void write_png(const std::filesystem::path& file, const Image& image);

/// The bytes of such a PNG. @throws std::invalid_argument as write_png
std::vector<std::byte> encode_png(const Image& image);

/// Pictures of more pixels are not read: twice those of the largest picture that is drawn.
inline constexpr std::size_t most_pixels = std::size_t{2} * 8192 * 8192;

/// Reads a PNG as 8-bit RGB, without loss: grey is spread to three channels, a palette looked up. A
/// picture that 8-bit RGB cannot hold is refused: one that is transparent somewhere, that has
/// 16-bit samples between the 8-bit ones, or that is animated.
/// @throws std::runtime_error naming the file and the reason.
Image read_png(const std::filesystem::path& file);

struct VideoSettings {
  int width = 1280;                  ///< pixels, even
  int height = 720;                  ///< pixels, even
  FrameRate frames_per_second = 30;  ///< more than 0, at most 1000
  int quality = 18;  ///< H.264 constant rate factor: 0 is best, 18 looks lossless, 51 is worst
};

/// H.264 in MP4 that browsers play: profile High, yuv420p, BT.709 tagged, constant frame rate,
/// index at the front. Frames go in one by one; the file appears under its name on finish() (or on
/// destruction after at least one frame, so that an interrupted run leaves a video of what was
/// finished).
class VideoWriter {
 public:
  /// @throws std::invalid_argument for settings out of range, std::runtime_error when the encoder
  /// is missing or the file can't be written.
  VideoWriter(const std::filesystem::path& file, const VideoSettings& settings);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// @throws std::invalid_argument for an image of another size (the video goes on without it),
  /// std::runtime_error when the file can't be written (the video is lost, and no file is left).
  void add(const Image& image);

  /// Needs at least one frame. A second call does nothing. @throws std::runtime_error as add().
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Pictures in a video, as its index says; 0: it can't be read.
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

  /// The next picture; none after the last. @throws std::runtime_error as the constructor
  std::optional<Image> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Name and version of the H.264 encoder and of the libav libraries, for reports.
std::string encoder_info();

/// Binary little-endian PLY of a triangle mesh: x y z [nx ny nz], faces. Normals are one per
/// vertex, or none. @throws std::invalid_argument for another number, std::runtime_error naming the
/// file.
void write_ply(const std::filesystem::path& file, const Mesh& mesh);

/// Attributes of particles for write_ply; all spans are as long as `positions`, or empty.
struct ParticleAttributes {
  std::span<const glm::vec3> positions;         ///< m
  std::span<const glm::vec3> velocities;        ///< m/s
  std::span<const float> densities;             ///< kg/m³
  std::span<const float> pressures;             ///< Pa
  std::span<const std::uint32_t> numbers = {};  ///< of the particles, each its own
};

/// Binary little-endian PLY of particles: x y z [vx vy vz] [density] [pressure] [id].
/// @throws std::invalid_argument for spans of unequal length, std::runtime_error naming the file.
void write_ply(const std::filesystem::path& file, const ParticleAttributes& particles);

}  // namespace spindrift::output
