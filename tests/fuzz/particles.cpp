// Kept particles: what is made up is given the checksum that it should have, since files without it
// go no farther.
#include "app/cache/particle_cache.hpp"
#include "app/files/checked_file.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  const std::string_view bytes = fuzz::text_of(data, size), magic = bytes.substr(0, 8);
  app::CheckedWriter file(fuzz::folder().path() / "0000.particles", magic);
  file.write(std::as_bytes(std::span(bytes.substr(magic.size()))));
  file.commit();
  try {
    const sim::Frame frame = app::ParticleCache(fuzz::folder().path()).read(0).frame;
    fuzz::require(frame.positions.size() == frame.ids.size() &&
                  frame.positions.size() == frame.constraint_multipliers.size());
  } catch (const std::runtime_error&) {
  }
  return 0;
}
