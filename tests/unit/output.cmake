spindrift_test(output spindrift_output
  unit/output_test.cpp unit/output_ply_test.cpp unit/output_video_test.cpp)
target_link_libraries(test_output PRIVATE PkgConfig::LIBAV)
