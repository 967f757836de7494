halfspace_find(Catch2)
include(Catch)

# Catch2 3 brings its own main. For version 2 it is built here, with the standard that the tests are built
# with.
add_library(halfspace_catch INTERFACE)
target_include_directories(halfspace_catch INTERFACE ${CMAKE_CURRENT_LIST_DIR})
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  target_link_libraries(halfspace_catch INTERFACE Catch2::Catch2WithMain)
else()
  add_library(halfspace_catch_main STATIC ${CMAKE_CURRENT_LIST_DIR}/catch_main.cpp)
  target_link_libraries(halfspace_catch_main PUBLIC Catch2::Catch2)
  # Not ours, large, and never what a test waits for.
  target_compile_options(halfspace_catch_main PRIVATE -O0 -fno-sanitize=all)
  target_link_libraries(halfspace_catch INTERFACE halfspace_catch_main)
endif()

# The headers of most test programs are compiled here, once. These programs spend their time in the library, so that
# little optimization is enough for them.
set(halfspace_test_options $<$<CONFIG:Release>:-O1>)
add_library(halfspace_test_headers OBJECT ${CMAKE_CURRENT_LIST_DIR}/catch_headers.cpp)
target_link_libraries(halfspace_test_headers PRIVATE halfspace_catch)
target_compile_options(halfspace_test_headers PRIVATE ${halfspace_test_options})
halfspace_precompile(halfspace_test_headers <catch.h> <algorithm> <cmath> <random> <string> <vector>)

# halfspace_add_test(name [LABEL label] [COST seconds] [OWN_FLAGS] SOURCES a.cpp b.cpp LIBRARIES halfspace_core)
#
# One Catch2 executable; each of its cases becomes a CTest test called "name:case". Sources may include
# "catch.h" and everything else relative to tests/. LABEL puts a CTest label on all its cases: those with the label
# slow are built where HALFSPACE_TEST_SLOW says so; those with the label threads run with the thread sanitizer.
# COST: the longest case's; cases start in the order of costs, so that none is alone at the end.
# OWN_FLAGS: its libraries bring compiler flags along, with which headers that were compiled without are of no use.
function(halfspace_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OWN_FLAGS" "LABEL;COST" "SOURCES;LIBRARIES")
  if(arg_LABEL STREQUAL slow AND NOT HALFSPACE_TEST_SLOW)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} halfspace_catch)
  if(NOT arg_OWN_FLAGS)
    target_compile_options(${name} PRIVATE ${halfspace_test_options})
    halfspace_precompile(${name} REUSE_FROM halfspace_test_headers)
  endif()
  if(arg_LABEL)
    list(APPEND properties LABELS ${arg_LABEL})
  endif()
  if(arg_COST)
    list(APPEND properties COST ${arg_COST})
  endif()
  catch_discover_tests(${name} TEST_PREFIX "${name}:" PROPERTIES ${properties})
endfunction()
