// Marks functions and lambdas that run wherever the particles are: on the processor, or, where a
// CUDA compiler reads them, on both sides; and those that are not copied into all the loops that
// call them.
#pragma once

#ifdef __CUDACC__
#define SPINDRIFT_HD __host__ __device__
#else
#define SPINDRIFT_HD
#endif

#define SPINDRIFT_APART __attribute__((noinline))
