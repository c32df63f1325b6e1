// The device backend as the rest of the program sees it; no CUDA header comes with it.
#pragma once

#include <memory>
#include <string>

#include "sim/run/simulation.hpp"

namespace spindrift::sim {

/// The device that loops run on. @throws std::runtime_error where there is none that can, why
std::string device_name();

/// CUDA's number for it. @throws std::runtime_error where there is none
int device_number();

std::unique_ptr<Engine> make_device_engine(const Settings& settings, Stop stop = nullptr);
std::unique_ptr<Engine> make_device_engine(const Settings& settings, const Frame& start,
                                           Stop stop = nullptr);

}  // namespace spindrift::sim
