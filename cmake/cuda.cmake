# Looks for CUDA, as SPINDRIFT_CUDA asks for it, and sets SPINDRIFT_CUDA_FOUND and why it is not.
set(SPINDRIFT_CUDA_FOUND OFF)
set(SPINDRIFT_CUDA_MISSING "")
find_program(SPINDRIFT_NVCC nvcc HINTS $ENV{CUDA_HOME}/bin $ENV{CUDACXX} /usr/local/cuda/bin)
if(SPINDRIFT_CUDA STREQUAL "OFF")
  set(SPINDRIFT_CUDA_MISSING "it was built with SPINDRIFT_CUDA=OFF")
elseif(NOT SPINDRIFT_NVCC)
  set(SPINDRIFT_CUDA_MISSING "it was built where no CUDA compiler (nvcc) was found")
elseif(SPINDRIFT_CUDA STREQUAL "AUTO" AND NOT EXISTS /proc/driver/nvidia/version)
  set(SPINDRIFT_CUDA_MISSING "it was built where no NVIDIA driver was found")
else()
  set(SPINDRIFT_CUDA_FOUND ON)
endif()
if(SPINDRIFT_CUDA STREQUAL "ON" AND NOT SPINDRIFT_CUDA_FOUND)
  message(FATAL_ERROR "SPINDRIFT_CUDA=ON, but no CUDA compiler (nvcc) was found: install the CUDA toolkit (12 or newer), or put nvcc into PATH")
endif()
if(NOT SPINDRIFT_CUDA_FOUND)
  return()
endif()

# Machine code from Turing to Hopper, and PTX for what comes after. Sources are compiled to PTX once, for Turing, and that is
# assembled for each: nine tenths of the time go to PTX, and loops come out with the same registers either way. CUB
# alone has other kernels for each (SPINDRIFT_CUB_CODE).
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
  set(CMAKE_CUDA_ARCHITECTURES OFF)
  set(SPINDRIFT_CUDA_CODE --generate-code=arch=compute_75,code=[compute_75,sm_75,sm_80,sm_86,sm_89,sm_90])
  foreach(number IN ITEMS 75 80 86 89)
    list(APPEND SPINDRIFT_CUB_CODE --generate-code=arch=compute_${number},code=sm_${number})
  endforeach()
  list(APPEND SPINDRIFT_CUB_CODE --generate-code=arch=compute_90,code=[compute_90,sm_90])
endif()
set(CMAKE_CUDA_COMPILER ${SPINDRIFT_NVCC})
enable_language(CUDA)
if(NOT DEFINED CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # CMake 3.25 does not know that nvcc 12 has it
  set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
  set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION "-std=c++20")
endif()
set(CMAKE_CUDA_STANDARD 20)
set(CMAKE_CUDA_STANDARD_REQUIRED ON)
find_package(CUDAToolkit REQUIRED)

# Contraction is off, as it is on the processor: a pair of particles gives the same numbers on both.
add_library(spindrift_cuda_options INTERFACE)
target_compile_definitions(spindrift_cuda_options INTERFACE SPINDRIFT_DEVICE)
target_compile_options(spindrift_cuda_options INTERFACE
  --extended-lambda --expt-relaxed-constexpr --fmad=false -Werror=all-warnings
  -diag-suppress=20012  # GLM's, which mark defaulted functions
  -Xcompiler=-Wall,-Wextra,-Wshadow,-Wconversion,-Wno-sign-conversion,-Werror,-fopenmp,-ffp-contract=off,-fno-math-errno)
target_include_directories(spindrift_cuda_options INTERFACE ${PROJECT_SOURCE_DIR})
