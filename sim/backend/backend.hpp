// The backend that a source is compiled for: its arrays, loops, cells and neighbour lists. There
// are two: OpenMP on the CPU, and the device, which is a CUDA GPU or, in tests, the CPU's cores.
//
// Sources that work on particles are written once and compiled once per backend, each time in an
// inline namespace of its own, so that both can be in one program:
//   namespace spindrift::sim::inline SPINDRIFT_BACKEND { … }
// The backends differ in nothing but the folder that is included here.
#pragma once

#ifdef SPINDRIFT_DEVICE
#define SPINDRIFT_BACKEND device
#include "sim/backend/device/arrays.hpp"
#include "sim/backend/device/cell_grid.hpp"
#include "sim/backend/device/cell_neighbours.hpp"
#include "sim/backend/device/executor.hpp"
#include "sim/backend/device/meshes.hpp"
#include "sim/backend/device/neighbours.hpp"
#else
#define SPINDRIFT_BACKEND openmp
#include "sim/backend/openmp/arrays.hpp"
#include "sim/backend/openmp/cell_grid.hpp"
#include "sim/backend/openmp/cell_neighbours.hpp"
#include "sim/backend/openmp/executor.hpp"
#include "sim/backend/openmp/meshes.hpp"
#include "sim/backend/openmp/neighbours.hpp"
#endif
