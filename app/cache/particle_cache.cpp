#include "app/cache/particle_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <span>
#include <stdexcept>

#include "app/files/checked_file.hpp"
#include "app/files/json_file.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

// The first bytes of the files. They change whenever the layout of the file does.
constexpr std::string_view frame_magic = "SPNDFRM6";
constexpr std::string_view readings_magic = "SPNDRDG1";

/// Says which frame of which simulation a file belongs to.
struct Label {
  std::array<char, 32> simulation{};  ///< hash of the simulation, in hexadecimal
  std::int64_t number = 0;            ///< number of the frame
};

struct Header {
  Label label;
  std::uint64_t particles;
  std::uint64_t boundary_samples;
  double time;
  double last_time_step;
  double allowed_time_step;
  sim::FrameStatistics statistics;
};
static_assert(std::is_trivially_copyable_v<Header>);

Label label_of(const std::string& simulation, int number) {
  Label label{.simulation = {}, .number = number};
  std::copy_n(simulation.begin(), std::min(simulation.size(), label.simulation.size()),
              label.simulation.begin());
  return label;
}

std::string text_of(const Label& label) {
  const auto end = std::find(label.simulation.begin(), label.simulation.end(), '\0');
  return {label.simulation.begin(), end};
}

template <class T>
T read_one(CheckedReader& in) {
  T value;
  in.read(std::as_writable_bytes(std::span(&value, 1)));
  return value;
}

/// Checks that a file's label is the expected one.
/// @throws std::runtime_error for a file of another frame or another simulation
void require_label(const Label& found, const Label& expected, const fs::path& file) {
  if (found.simulation != expected.simulation || found.number != expected.number)
    throw std::runtime_error(fmt::format("{} is frame {} of simulation {}, not frame {} of {}",
                                         file.string(), found.number, text_of(found),
                                         expected.number, text_of(expected)));
}

/// The result of f, or nothing where f throws. Only std::bad_alloc is passed on.
template <class F>
auto or_nothing(F f) -> std::optional<decltype(f())> {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

ParticleCache::ParticleCache(fs::path folder) : folder_(std::move(folder)) {
  CheckedReader in(file(0), frame_magic);
  simulation_ = text_of(read_one<Label>(in));
}

fs::path ParticleCache::file(int number) const {
  return folder_ / fmt::format("{:04}.particles", number);
}

CachedFrame ParticleCache::read(int number) const {
  CheckedReader in(file(number), frame_magic);
  const auto header = read_one<Header>(in);
  require_label(header.label, label_of(simulation_, number), file(number));
  CachedFrame cached;
  cached.statistics = header.statistics;
  sim::Frame& frame = cached.frame;
  frame.time = header.time;
  frame.last_time_step = header.last_time_step;
  frame.allowed_time_step = header.allowed_time_step;
  std::uint64_t per_particle = 0;
  sim::Frame::for_each_of_particles(frame,
                                    [&](const auto& array) { per_particle += sizeof array[0]; });
  const std::uint64_t size = in.remaining();
  if (header.particles > size || header.boundary_samples > size ||
      size != header.particles * per_particle + header.boundary_samples * sizeof(float))
    in.fail();
  const auto read_array = [&](auto& array, std::uint64_t count) {
    array.resize(count);
    in.read(std::as_writable_bytes(std::span(array)));
  };
  sim::Frame::for_each_of_particles(frame,
                                    [&](auto& array) { read_array(array, header.particles); });
  read_array(frame.boundary_pressures, header.boundary_samples);
  in.finish();
  return cached;
}

std::optional<CachedFrame> ParticleCache::find(int number) const {
  return or_nothing([&] { return read(number); });
}

void ParticleCache::write(int number, const CachedFrame& cached) const {
  output::make_folders(folder_);
  CheckedWriter out(file(number), frame_magic);
  const sim::Frame& frame = cached.frame;
  const Header header{.label = label_of(simulation_, number),
                      .particles = frame.positions.size(),
                      .boundary_samples = frame.boundary_pressures.size(),
                      .time = frame.time,
                      .last_time_step = frame.last_time_step,
                      .allowed_time_step = frame.allowed_time_step,
                      .statistics = cached.statistics};
  out.write(std::as_bytes(std::span(&header, 1)));
  const auto write_array = [&](const auto& array) { out.write(std::as_bytes(std::span(array))); };
  sim::Frame::for_each_of_particles(frame, write_array);
  write_array(frame.boundary_pressures);
  out.commit();
}

void ParticleCache::write_readings(int number, const std::string& name,
                                   const std::vector<double>& values) const {
  output::make_folders(folder_);
  CheckedWriter out(folder_ / fmt::format("{:04}.{}", number, name), readings_magic);
  const Label label = label_of(simulation_, number);
  out.write(std::as_bytes(std::span(&label, 1)));
  out.write(std::as_bytes(std::span(values)));
  out.commit();
}

std::optional<std::vector<double>> ParticleCache::read_readings(int number,
                                                                const std::string& name) const {
  return or_nothing([&] {
    const fs::path file = folder_ / fmt::format("{:04}.{}", number, name);
    CheckedReader in(file, readings_magic);
    require_label(read_one<Label>(in), label_of(simulation_, number), file);
    std::vector<double> values(in.remaining() / sizeof(double));
    in.read(std::as_writable_bytes(std::span(values)));
    in.finish();
    return values;
  });
}

void ParticleCache::write_record(const SimulationRecord& record) const {
  output::make_folders(folder_);
  output::write_file(folder_ / simulation_record_file, json_of(record).dump(1) + "\n");
}

std::optional<SimulationRecord> ParticleCache::read_record() const {
  return or_nothing(
      [&] { return simulation_record_of(json_in(folder_ / simulation_record_file)); });
}

}  // namespace spindrift::app
