// How well each particle is surrounded by others, and the kernel that follows from it.
//
// The coverage of particle i is c_i = sum_j d^3 W(x_i - x_j, h): 1 deep inside the liquid, about
// 0.77 at a flat surface, 0.53 in a sheet one particle thick, 0.23 in a thread, 0.1 for a particle
// alone (with h = 2.5 d). A wide kernel makes a smooth surface but loses features thinner than
// itself, so where the coverage is small
//  - kernels are raised until the field passes the iso-value about 0.62 d from the particle: a drop
//    of one particle keeps a volume of about d^3, a sheet of one layer a thickness of about d. This
//    is the usual division by density (Solenthaler & Pajarola 2008, "Density contrast SPH
//    interfaces"), but for thin features only: the bulk's surface stays where it is;
//  - kernels are made narrower, from the rims of sheets to single drops, so that drops do not melt
//    together long before they touch.
#pragma once

#include <cstdint>
#include <vector>

#include "render/surface/particle_bins.hpp"

namespace spindrift::surface {

/// Particle j adds amplitude * kernel_shape(1 - r^2 / radius^2) to the field.
struct ParticleKernel {
  float amplitude;
  float radius;  ///< in spacings
};

struct Coverage {
  std::vector<ParticleKernel> kernels;  ///< per sorted particle
  std::vector<std::uint8_t> enclosed;   ///< per bin: no particle in it is near a surface
};

/// @param bins of an edge equal to the kernel's support
Coverage measure_coverage(const ParticleBins& bins, float iso_value);

}  // namespace spindrift::surface
