// Chooses which of a machine's EGL devices to draw with.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spindrift::gl {

/// The properties of an EGL device that matter for the choice.
struct EglDevice {
  bool software = false;                ///< whether it draws on the processor's cores
  std::optional<int> cuda_device = {};  ///< CUDA's number of the GPU (EGL_NV_device_cuda)
};

/// Returns the indices of the devices in the order in which to try them: the GPU that CUDA computes
/// on, then other GPUs, then software. Devices of equal rank stay in EGL's order.
/// @param cuda_device CUDA's number of the GPU that it computes on; none where it does not
std::vector<std::size_t> order_to_try(std::span<const EglDevice> devices,
                                      std::optional<int> cuda_device);

/// Describes device `chosen` in words, and says whether CUDA computes on another one.
std::string name_of(std::span<const EglDevice> devices, std::size_t chosen,
                    std::optional<int> cuda_device);

}  // namespace spindrift::gl
