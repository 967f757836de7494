# The polyhedra and the other engines that the 3D oracle and the 3D benchmark share. Either folder may be
# built without the other; the one that comes first makes the libraries.
halfspace_find(CGAL)
find_package(Eigen3 REQUIRED CONFIG)  # CGAL brings a module of that name, which has no target
foreach(name FCL Bullet ODE)
  halfspace_find(${name})
endforeach()

if(TARGET peers_3d)
  return()
endif()

set(tests ${CMAKE_CURRENT_LIST_DIR}/..)

add_library(polyhedra_3d STATIC
  ${tests}/oracles/polyhedron_3d.cpp ${tests}/oracles/random_polyhedra.cpp
  ${tests}/oracles/minkowski_facets.cpp)
halfspace_in_batches(polyhedra_3d)
target_include_directories(polyhedra_3d PUBLIC ${tests})
target_link_libraries(polyhedra_3d PUBLIC halfspace::halfspace PRIVATE CGAL::CGAL)

add_library(peers_3d STATIC
  ${tests}/benchmarks/peer_libccd.cpp ${tests}/benchmarks/peer_fcl.cpp ${tests}/benchmarks/peer_bullet.cpp
  ${tests}/benchmarks/peer_ode.cpp ${tests}/benchmarks/peer_halfspace.cpp
  ${tests}/benchmarks/stepped_pairs_3d.cpp)
target_link_libraries(peers_3d
  PUBLIC polyhedra_3d
  PRIVATE halfspace_core ccd fcl PkgConfig::bullet_double PkgConfig::ode Eigen3::Eigen)
