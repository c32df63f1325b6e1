#include "render/gl/egl/egl_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace spindrift::gl {

std::vector<std::size_t> order_to_try(std::span<const EglDevice> devices,
                                      std::optional<int> cuda_device) {
  std::vector<std::size_t> order(devices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t k) {
    if (cuda_device && devices[k].cuda_device == cuda_device)
      return 0;
    return devices[k].software ? 2 : 1;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

std::string name_of(std::span<const EglDevice> devices, std::size_t chosen,
                    std::optional<int> cuda_device) {
  const EglDevice& device = devices[chosen];
  std::string name = fmt::format("EGL device {} of {}", chosen + 1, devices.size());
  if (device.software)
    name += ", software";
  if (device.cuda_device)
    name += fmt::format(", CUDA device {}", *device.cuda_device);
  if (cuda_device && device.cuda_device != cuda_device)
    name += fmt::format("; CUDA computes on its device {}", *cuda_device);
  return name;
}

}  // namespace spindrift::gl
