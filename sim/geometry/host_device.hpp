// Macros that mark functions and lambdas for the host and the device.
#pragma once

/// Marks a function or lambda that runs wherever the particles are: a CUDA compiler compiles it for
/// the host and the device, any other compiler for the host alone.
#ifdef __CUDACC__
#define SPINDRIFT_HD __host__ __device__
#else
#define SPINDRIFT_HD
#endif

/// Marks a large function that is not to be inlined into all the loops that call it.
#define SPINDRIFT_APART __attribute__((noinline))
