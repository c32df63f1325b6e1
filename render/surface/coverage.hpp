// How well each particle is surrounded by others, and the volume that it stands for.
//
// The coverage of particle i is c_i = sum_j d^3 W(x_i - x_j): 1 deep inside the liquid, about 0.77
// at a flat surface, about 0.5 in a sheet one particle thick, 0.1 for a particle alone. Where it is
// small, the particles are given more volume, so that the field still reaches the iso-value at
// about half a spacing from them: a drop of one particle keeps a volume of about d^3 and a sheet of
// one layer a thickness of about d, although the kernel is much wider than either. This is the
// usual division by density (Solenthaler & Pajarola 2008, "Density contrast SPH interfaces"), but
// only for thin features: the surface of the bulk stays where a uniform volume puts it.
#pragma once

#include <cstdint>
#include <vector>

#include "render/surface/particle_bins.hpp"

namespace spindrift::surface {

/// The smoothing kernel W(r) = 315 / (64 pi h^3) (1 - r^2/h^2)^3 of Mueller et al. 2003, without a
/// square root; r and h in spacings.
inline float kernel_peak(float support) {
  return 315.0f / (64.0f * 3.14159265f * support * support * support);
}

struct Coverage {
  std::vector<float> volume;           ///< per sorted particle, in cubed spacings; at least 1
  std::vector<std::uint8_t> enclosed;  ///< per bin: no particle in it is near a surface
};

/// @param bins of an edge equal to the kernel's support
Coverage measure_coverage(const ParticleBins& bins, float iso_value);

}  // namespace spindrift::surface
