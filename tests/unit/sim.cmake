spindrift_test(sim spindrift_sim unit/sim_kernels_test.cpp unit/sim_neighbours_test.cpp
               unit/sim_boundary_test.cpp unit/sim_step_test.cpp)
target_compile_options(test_sim PRIVATE -Wno-psabi)
spindrift_test(physics spindrift_sim physics/motion_test.cpp physics/rest_test.cpp
               physics/determinism_test.cpp)
