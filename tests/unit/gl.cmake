spindrift_test(gl spindrift_gl unit/gl_test.cpp unit/gl_golden_test.cpp)
target_link_libraries(test_gl PRIVATE PkgConfig::STB fmt::fmt)
target_compile_definitions(test_gl PRIVATE RESULT_DIR="${CMAKE_CURRENT_BINARY_DIR}")
