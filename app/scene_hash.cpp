#include <fmt/format.h>

#include "app/scene.hpp"
#include "app/scene_values.hpp"

namespace spindrift::app {
namespace {

// To be raised when the same settings begin to give other particles, or the cache's files change.
constexpr int particles_version = 2;

__extension__ typedef unsigned __int128 Bits128;

/// FNV-1a with 128 bits (Fowler, Noll, Vo).
Bits128 fnv1a(std::string_view text) {
  const Bits128 prime = (Bits128{1} << 88) + 0x13b;
  Bits128 hash = (Bits128{0x6c62272e07bb0142u} << 64) + 0x62b821756295c58du;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  }
  return hash;
}

}  // namespace

std::string simulation_hash(const Scene& scene) {
  Json what = json_of(scene.simulation);
  what["frames_per_second"] = scene.video.frames_per_second;
  what["particles_version"] = particles_version;
  const Bits128 hash = fnv1a(what.dump());
  return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash >> 64),
                     static_cast<std::uint64_t>(hash));
}

}  // namespace spindrift::app
