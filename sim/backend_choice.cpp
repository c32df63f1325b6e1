#include "sim/backend_choice.hpp"

#include <stdexcept>

#ifdef SPINDRIFT_CUDA
#include "sim/device/device_engine.hpp"
#endif

namespace spindrift::sim {

#ifdef SPINDRIFT_CUDA

std::string why_not_cuda(const Settings& settings) {
  try {
    device_name();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return missing_on_device(settings);
}

std::string cuda_device() {
  try {
    return device_name();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

#else

std::string why_not_cuda(const Settings&) {
  return cuda_device();
}

std::string cuda_device() {
  return "this program has no CUDA backend: " SPINDRIFT_CUDA_MISSING;
}

#endif

BackendChoice choose_backend(const Settings& settings) {
  if (settings.solver.backend == Backend::cpu)
    return {Backend::cpu, "it was asked for"};
  if (settings.solver.backend == Backend::cuda)
    return {Backend::cuda, "it was asked for; " + cuda_device()};
  const std::string why_not = why_not_cuda(settings);
  if (!why_not.empty())
    return {Backend::cpu, why_not};
  return {Backend::cuda, cuda_device()};
}

}  // namespace spindrift::sim
