#include "sim/run/device_engine.hpp"

#include <stdexcept>

#include "sim/run/engine.hpp"

namespace spindrift::sim {

#ifdef __CUDACC__

namespace {

void check_found(cudaError_t error) {
  if (error != cudaSuccess)
    throw std::runtime_error(std::string("CUDA finds no GPU that it can use: ") +
                             cudaGetErrorString(error));
}

}  // namespace

int device_number() {
  int number = 0;
  check_found(cudaGetDevice(&number));
  return number;
}

std::string device_name() {
  cudaDeviceProp properties;
  check_found(cudaGetDeviceProperties(&properties, device_number()));
  try {  // a GPU may be older than all that the program was built for
    launch(1, [] SPINDRIFT_HD(std::uint32_t) {});
    wait();
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("CUDA cannot use the GPU ") + properties.name + ": " +
                             error.what());
  }
  return properties.name;
}

#else

int device_number() {
  return 0;
}

std::string device_name() {
  return "the processor's cores, by Thrust";
}

#endif

std::unique_ptr<Engine> make_device_engine(const Settings& settings, Stop stop) {
  return make_engine(settings, stop);
}

std::unique_ptr<Engine> make_device_engine(const Settings& settings, const Frame& start,
                                           Stop stop) {
  return make_engine(settings, start, stop);
}

}  // namespace spindrift::sim
