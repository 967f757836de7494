# The program of the script `instructions`, where valgrind can run it: beside the tests as well as the benchmarks.
if(NOT CMAKE_SYSTEM_NAME STREQUAL Linux OR CMAKE_CROSSCOMPILING OR CMAKE_CXX_FLAGS MATCHES "fsanitize")
  return()
endif()
find_package(Eigen3 REQUIRED NO_MODULE)

set(here ${CMAKE_CURRENT_LIST_DIR})
add_executable(count_instructions
  ${here}/count_instructions.cpp ${here}/counted_pairs.cpp ${here}/counted_scenes.cpp ${here}/settled_scenes.cpp)
target_include_directories(count_instructions PRIVATE ${here} ${here}/..)
target_link_libraries(count_instructions PRIVATE halfspace::halfspace Eigen3::Eigen ${CMAKE_DL_LIBS})
# An earlier library lacks functions that only some scenes call.
target_link_options(count_instructions PRIVATE LINKER:-z,lazy)
set_target_properties(count_instructions PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/benchmarks)

if(HALFSPACE_TEST_INSTRUCTIONS)
  add_test(NAME "instructions: what is faulty ends with its reason"
    COMMAND ${SYSTEM_PYTHON} -B ${here}/check_instructions ${PROJECT_BINARY_DIR})
endif()
