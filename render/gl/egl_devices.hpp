// Which of a machine's EGL devices to draw with.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spindrift::gl {

/// An EGL device, as far as it matters for the choice.
struct EglDevice {
  bool software = false;                ///< draws on the processor's cores
  std::optional<int> cuda_device = {};  ///< CUDA's number for it (EGL_NV_device_cuda)
};

/// The numbers of the devices in the order in which to try them: the GPU that CUDA computes on,
/// then other GPUs, then software; equals as EGL has them.
/// @param cuda_device CUDA's number of that GPU; none: CUDA does not compute here
std::vector<std::size_t> order_to_try(std::span<const EglDevice> devices,
                                      std::optional<int> cuda_device);

/// One of the devices in words, with how it stands to the GPU that CUDA computes on.
std::string name_of(std::span<const EglDevice> devices, std::size_t chosen,
                    std::optional<int> cuda_device);

}  // namespace spindrift::gl
