#include <fmt/format.h>

#include "app/scene/scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"
#include "sim/geometry/mesh/mesh_body.hpp"
#include "sim/run/backend_choice.hpp"

namespace spindrift::app {
namespace {

// Must be raised whenever the same settings begin to give other particles, or the format of the
// cache's files changes.
constexpr int particles_version = 11;

__extension__ using Bits128 = unsigned __int128;

/// The 128-bit FNV-1a hash of a text (Fowler, Noll, Vo).
Bits128 fnv1a(std::string_view text) {
  const Bits128 prime = (Bits128{1} << 88) + 0x13b;
  Bits128 hash = (Bits128{0x6c62272e07bb0142u} << 64) + 0x62b821756295c58du;
  for (const char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  return hash;
}

std::string text_of(Bits128 hash) {
  return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash >> 64),
                     static_cast<std::uint64_t>(hash));
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Replaces the file's name of a mesh in the scene's JSON by hashes of its vertices and triangles
/// as they are placed in the scene.
void name_by_content(const sim::Shape& shape, Json& json) {
  if (const auto* mesh = std::get_if<sim::TriangleMesh>(&shape)) {
    const sim::TriangleSurface& surface = mesh->body->surface();
    json["mesh"]["file"] = Json::array(
        {text_of(fnv1a(bytes_of(surface.vertices))), text_of(fnv1a(bytes_of(surface.triangles)))});
  }
}

}  // namespace

std::string simulation_hash(const Scene& scene) {
  Json what = json_of(scene.simulation);
  for (std::size_t i = 0; i < scene.simulation.fluid.volumes.size(); ++i)
    name_by_content(scene.simulation.fluid.volumes[i].shape, what["fluid"]["volumes"][i]);
  for (std::size_t i = 0; i < scene.simulation.obstacles.size(); ++i)
    name_by_content(scene.simulation.obstacles[i].shape, what["obstacles"][i]);
  for (std::size_t i = 0; i < scene.simulation.sinks.size(); ++i)
    name_by_content(scene.simulation.sinks[i].shape, what["sinks"][i]);
  // The backends' particles differ by rounding. Only CUDA is named, so that "auto" and "cpu" give
  // the same hash where the processor computes.
  what["solver"].erase("backend");
  if (sim::choose_backend(scene.simulation).backend == sim::Backend::cuda)
    what["solver"]["backend"] = "cuda";
  what["frames_per_second"] = json_of(scene.video.frames_per_second);
  if (!scene.probes.empty() && scene.probes_rate > 0)
    what["probes_rate"] = scene.probes_rate;  // a time step ends at every reading of the probes
  what["particles_version"] = particles_version;
  return text_hash(what.dump());
}

std::string text_hash(std::string_view text) {
  return text_of(fnv1a(text));
}

}  // namespace spindrift::app
