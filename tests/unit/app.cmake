file(GLOB app_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/app_*.cpp)
spindrift_test(app spindrift_app ${app_tests})
