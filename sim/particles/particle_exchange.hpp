// Adds particles to the liquid and takes some away; emitters, sinks and open faces use it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class ParticleExchange {
 public:
  /// Adds particles after all others, with zero in every other field that lasts from step to step,
  /// such as pressure.
  /// @param positions of the new particles, m
  /// @param velocity  of all new particles, m/s
  /// @param ids       one per new particle
  void append(Executor& executor, Particles& particles, const std::vector<glm::vec3>& positions,
              const glm::vec3& velocity, const std::vector<std::uint32_t>& ids);

  /// Keeps the particles with the indices `kept`, in that order, and takes all others away.
  void keep(Executor& executor, Particles& particles, const Array<std::uint32_t>& kept);

  std::size_t memory_bytes() const { return bytes_of(new_positions_, new_ids_); }

 private:
  Array<glm::vec3> new_positions_;
  Array<std::uint32_t> new_ids_;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
