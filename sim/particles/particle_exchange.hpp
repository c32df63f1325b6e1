// Adds particles to those there are, and takes some away.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class ParticleExchange {
 public:
  /// Adds particles of the given velocity, m/s, without pressure, after all others.
  void append(Executor& executor, Particles& particles, const std::vector<glm::vec3>& positions,
              const glm::vec3& velocity, const std::vector<std::uint32_t>& ids);

  /// Keeps the particles whose numbers these are, in their order, and takes the others away.
  void keep(Executor& executor, Particles& particles, const Array<std::uint32_t>& kept);

 private:
  Array<glm::vec3> new_positions_;
  Array<std::uint32_t> new_ids_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
