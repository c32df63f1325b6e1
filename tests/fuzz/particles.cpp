// Kept particles.
#include "app/particle_cache.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  fuzz::folder().write("0000.particles", fuzz::text_of(data, size));
  try {
    const app::KeptFrame kept = app::ParticleCache(fuzz::folder().path()).read(0);
    fuzz::require(kept.frame.positions.size() == kept.frame.ids.size());
  } catch (const std::runtime_error&) {
  }
  return 0;
}
