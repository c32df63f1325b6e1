#include "app/particle_cache.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <fstream>
#include <span>
#include <stdexcept>

#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

/// Changes whenever the layout of the file does.
constexpr std::array<char, 8> magic = {'S', 'P', 'N', 'D', 'F', 'R', 'M', '5'};

struct Header {
  std::array<char, 8> magic;
  std::uint64_t particles;
  std::uint64_t boundary_samples;
  double time;
  double last_time_step;
  double allowed_time_step;
  sim::FrameStatistics statistics;
};
static_assert(std::is_trivially_copyable_v<Header>);

/// The arrays of a frame in their order in the file; f takes a vector of numbers or of vectors.
template <class Frame, class F>
void for_each_array(Frame& frame, F f) {
  f(frame.positions);
  f(frame.velocities);
  f(frame.densities);
  f(frame.pressures);
  f(frame.multipliers);
  f(frame.ids);
  f(frame.boundary_pressures);
}

}  // namespace

std::filesystem::path ParticleCache::file(int number) const {
  return folder_ / fmt::format("{:04}.particles", number);
}

bool ParticleCache::has(int number) const {
  return std::filesystem::exists(file(number));
}

KeptFrame ParticleCache::read(int number) const {
  const std::filesystem::path name = file(number);
  std::ifstream in(name, std::ios::binary);
  if (!in)
    throw std::runtime_error(
        fmt::format("cannot read {}: {}", name.string(), std::strerror(errno)));
  Header header;
  in.read(reinterpret_cast<char*>(&header), sizeof header);
  if (!in || header.magic != magic)
    throw std::runtime_error(
        fmt::format("{} is not a particle file of this version", name.string()));
  KeptFrame kept;
  kept.statistics = header.statistics;
  sim::Frame& frame = kept.frame;
  frame.time = header.time;
  frame.last_time_step = header.last_time_step;
  frame.allowed_time_step = header.allowed_time_step;
  const std::uintmax_t size = std::filesystem::file_size(name);
  const std::uint64_t per_particle = 2 * sizeof(glm::vec3) + 4 * sizeof(float);
  if (header.particles > size || header.boundary_samples > size ||
      size !=
          sizeof header + header.particles * per_particle + header.boundary_samples * sizeof(float))
    throw std::runtime_error(fmt::format("{} is cut short or damaged; remove it", name.string()));
  for_each_array(frame, [&](auto& array) {
    const bool boundary =
        static_cast<void*>(&array) == static_cast<void*>(&frame.boundary_pressures);
    array.resize(boundary ? header.boundary_samples : header.particles);
    in.read(reinterpret_cast<char*>(array.data()),
            static_cast<std::streamsize>(array.size() * sizeof array[0]));
  });
  if (!in)
    throw std::runtime_error(fmt::format("{} could not be read to its end", name.string()));
  return kept;
}

void ParticleCache::write_readings(int number, const std::string& name,
                                   const std::vector<double>& values) const {
  std::filesystem::create_directories(folder_);
  output::AtomicFile out(folder_ / fmt::format("{:04}.{}", number, name));
  out.write(std::as_bytes(std::span(values)));
  out.commit();
}

std::optional<std::vector<double>> ParticleCache::read_readings(int number,
                                                                const std::string& name) const {
  std::ifstream in(folder_ / fmt::format("{:04}.{}", number, name), std::ios::binary);
  if (!in)
    return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

void ParticleCache::write(int number, const KeptFrame& kept) const {
  std::filesystem::create_directories(folder_);
  output::AtomicFile out(file(number));
  const sim::Frame& frame = kept.frame;
  const Header header{magic,          frame.positions.size(), frame.boundary_pressures.size(),
                      frame.time,     frame.last_time_step,   frame.allowed_time_step,
                      kept.statistics};
  out.write(std::as_bytes(std::span(&header, 1)));
  for_each_array(frame, [&](const auto& array) { out.write(std::as_bytes(std::span(array))); });
  out.commit();
}

}  // namespace spindrift::app
