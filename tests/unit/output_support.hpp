// What the tests of the writers share.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "render/image.hpp"

namespace spindrift::output_test {

/// A folder of its own that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "spindrift-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

  /// Number of entries, hidden ones too.
  int entries() const {
    return static_cast<int>(std::distance(std::filesystem::directory_iterator(path_),
                                          std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

/// Runs `writer` in a child process that may write no more than `bytes` to a file, as on a full
/// disk. True if it throws std::runtime_error whose text contains `name` and the system's reason.
template <class Writer>
bool fails_when_full(std::size_t bytes, const std::string& name, Writer writer) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int code = 1;
    try {
      writer();
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      const bool good =
          text.find(name) != std::string::npos && text.find("File too large") != std::string::npos;
      code = good ? 0 : 2;
    } catch (...) {
      code = 3;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Independent noise in every channel, the same for the same seed.
inline Image noise(int width, int height, std::uint32_t seed) {
  Image image(width, height);
  for (std::uint8_t& value : image.pixels) {
    seed = seed * 1664525u + 1013904223u;
    value = static_cast<std::uint8_t>(seed >> 24);
  }
  return image;
}

inline Image solid(int width, int height, int red, int green, int blue) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = static_cast<std::uint8_t>(red);
    image.pixels[i + 1] = static_cast<std::uint8_t>(green);
    image.pixels[i + 2] = static_cast<std::uint8_t>(blue);
  }
  return image;
}

/// A bright background above blue waves that travel with time (s).
inline Image waves(int width, int height, double time) {
  Image image(width, height);
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::clamp(255.0 * value, 0.0, 255.0));
  };
  std::size_t at = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double x = double(column) / width;
      const double y = double(row) / height;
      const double surface = 0.45 + 0.06 * std::sin(7 * x + 2 * time);
      const double blend = std::clamp((y - surface) * 40.0, 0.0, 1.0);
      const double light = 0.5 + 0.25 * std::sin(23 * x - 3 * time) * std::sin(31 * y + time);
      image.pixels[at++] = byte((1 - blend) * (0.85 - 0.2 * y) + blend * 0.2 * light);
      image.pixels[at++] = byte((1 - blend) * (0.88 - 0.2 * y) + blend * (0.1 + 0.5 * light));
      image.pixels[at++] = byte((1 - blend) * (0.93 - 0.2 * y) + blend * (0.3 + 0.6 * light));
    }
  }
  return image;
}

}  // namespace spindrift::output_test
