#include "app/exports/particles_ply.hpp"

#include <algorithm>
#include <numeric>

#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

template <class T>
std::vector<T> ordered(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    result[k] = values[order[k]];
  return result;
}

}  // namespace

void write_particles_ply(const std::filesystem::path& file, const ExportedFrame& exported) {
  const sim::Frame& frame = exported.particles;
  const bool with_ids = exported.scene.simulation.exchanges_particles();
  std::vector<std::uint32_t> order(frame.ids.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return frame.ids[a] < frame.ids[b]; });
  std::vector<output::ParticleAttribute> attributes;
  sim::Frame::for_each_field([&](const auto& field) {
    const auto& values = frame.*field.member;
    if (field.use == sim::FieldUse::shown || (field.use == sim::FieldUse::identity && with_ids))
      attributes.push_back({field.properties, field.unit, ordered(values, order)});
  });
  output::write_ply(file, attributes);
}

}  // namespace spindrift::app
