#include "sim/device/device_engine.hpp"

#include <stdexcept>

#include "sim/engine.hpp"

namespace spindrift::sim {

std::string device_name() {
#ifdef __CUDACC__
  const auto check = [](cudaError_t error) {
    if (error != cudaSuccess)
      throw std::runtime_error(std::string("CUDA finds no GPU that it can use: ") +
                               cudaGetErrorString(error));
  };
  int number = 0;
  cudaDeviceProp properties;
  check(cudaGetDevice(&number));
  check(cudaGetDeviceProperties(&properties, number));
  try {  // a GPU may be older than all that the program was built for
    launch(1, [] SPINDRIFT_HD(std::uint32_t) {});
    wait();
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("CUDA cannot use the GPU ") + properties.name + ": " +
                             error.what());
  }
  return properties.name;
#else
  return "the processor's cores, by Thrust";
#endif
}

std::unique_ptr<Engine> make_device_engine(const Settings& settings) {
  return make_engine(settings);
}

std::unique_ptr<Engine> make_device_engine(const Settings& settings, const Frame& start) {
  return make_engine(settings, start);
}

}  // namespace spindrift::sim
