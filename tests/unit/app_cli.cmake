# The program as a user types it, once for each part of the script.
foreach(part IN ITEMS usage scenes errors info)
  add_test(NAME "cli: ${part}"
           COMMAND ${PROJECT_SOURCE_DIR}/tests/cli/command_line.sh $<TARGET_FILE:spindrift> ${part}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties("cli: ${part}" PROPERTIES TIMEOUT 120)
endforeach()
