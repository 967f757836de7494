# The scenes and measures that tests and benchmarks of the adapter share. Either may be built without the other; the one
# that comes first makes the library.
if(TARGET box2d_parts)
  return()
endif()

set(tests ${CMAKE_CURRENT_LIST_DIR}/..)

add_library(box2d_parts STATIC
  ${tests}/benchmarks/box2d_scenes.cpp
  ${tests}/box2d/face_gaps.cpp
  ${tests}/box2d/force_scenes.cpp
  ${tests}/box2d/posed_polygons.cpp
  ${tests}/box2d_comparison/forces.cpp)
target_include_directories(box2d_parts PUBLIC ${tests})
target_link_libraries(box2d_parts PUBLIC halfspace::box2d)
halfspace_in_batches(box2d_parts)
