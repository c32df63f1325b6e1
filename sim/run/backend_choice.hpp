// Which backend runs a simulation.
#pragma once

#include <optional>
#include <string>

#include "sim/core/settings.hpp"

namespace spindrift::sim {

struct BackendChoice {
  Backend backend = Backend::cpu;       ///< cpu or cuda
  std::string reason;                   ///< why, in words
  std::optional<int> cuda_device = {};  ///< CUDA's number of the GPU, where the backend is that
};

/// What settings.solver.backend comes to on this machine. "auto" is CUDA where that can run the
/// settings; "cuda" is CUDA whether it can or not.
BackendChoice choose_backend(const Settings& settings);

/// Why the backend that the settings ask for cannot run them here, in words; empty: it can.
std::string why_refused(const Settings& settings);

/// The GPU that CUDA runs on, or why there is none.
std::string cuda_device();

}  // namespace spindrift::sim
