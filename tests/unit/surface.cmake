spindrift_test(surface spindrift_surface unit/surface_test.cpp unit/surface_internals_test.cpp)
target_link_libraries(test_surface PRIVATE OpenMP::OpenMP_CXX fmt::fmt)
