// Measures how well each particle is surrounded by others, and chooses from that the kernel that
// the particle adds to the scalar field whose iso-surface is the liquid's surface.
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

/// A particle's kernel: at a distance r it adds amplitude * kernel_shape(1 - r^2 / radius^2) to the
/// field.
struct ParticleKernel {
  float amplitude;
  float radius;  ///< support radius, in particle spacings
};

/// The kernels of all particles, and which bins lie deep inside the liquid.
struct Coverage {
  std::vector<ParticleKernel> kernels;  ///< one per particle, in the order of the bins
  std::vector<std::uint8_t> enclosed;   ///< per bin: 1 if no particle in it is near a surface
};

/// Measures the coverage of every particle and chooses its kernel.
/// @param bins      bins whose edge equals the support radius h of the full kernel
/// @param iso_value value of the field at the surface
Coverage measure_coverage(const ParticleBins& bins, float iso_value);

}  // namespace spindrift::surface
