#include "sim/run/backend_choice.hpp"

#include <stdexcept>

#ifdef SPINDRIFT_CUDA
#include "sim/run/device_engine.hpp"
#endif

namespace spindrift::sim {

std::string cuda_device() {
#ifdef SPINDRIFT_CUDA
  try {
    return device_name();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
#else
  return "this program has no CUDA backend: " SPINDRIFT_CUDA_MISSING;
#endif
}

namespace {

/// Why the CUDA backend cannot run here, in words; empty: it can.
std::string why_not_cuda() {
#ifdef SPINDRIFT_CUDA
  try {
    device_name();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
#else
  return cuda_device();
#endif
}

std::optional<int> cuda_device_number() {
#ifdef SPINDRIFT_CUDA
  return device_number();
#else
  return {};
#endif
}

}  // namespace

std::string why_refused(const Settings& settings) {
  if (settings.solver.backend != Backend::cuda)
    return {};
  const std::string why_not = why_not_cuda();
  return why_not.empty()
             ? why_not
             : "solver.backend is \"cuda\", but " + why_not + "; ask for \"cpu\" or \"auto\"";
}

BackendChoice choose_backend(const Settings& settings) {
  if (settings.solver.backend == Backend::cpu)
    return {Backend::cpu, "solver.backend is \"cpu\"", {}};
  const std::string why_not = why_not_cuda();
  const std::optional<int> gpu = why_not.empty() ? cuda_device_number() : std::nullopt;
  if (settings.solver.backend == Backend::cuda)
    return {Backend::cuda, "solver.backend is \"cuda\"; " + cuda_device(), gpu};
  if (!why_not.empty())
    return {Backend::cpu, why_not, {}};
  return {Backend::cuda, cuda_device(), gpu};
}

}  // namespace spindrift::sim
