# Debian packages, by cpack; the preset `packages` has the paths of Debian. Files belong to a package by the COMPONENT
# they are installed with.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libhalfspace)
# An address that nobody has: who gives the packages to others puts theirs here, by cpack -D CPACK_PACKAGE_CONTACT=...
set(CPACK_PACKAGE_CONTACT "libhalfspace authors <libhalfspace@halfspace.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/capi)  # this library is in no package yet
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_documents.cmake)
set(CPACK_HALFSPACE_LICENCE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_HALFSPACE_NOTICES ${PROJECT_SOURCE_DIR}/docs/notices)
set(CPACK_HALFSPACE_CHANGES ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
set(CPACK_COMPONENTS_ALL)

# halfspace_package(COMPONENT NAME name SECTION section CONTENT what [DEPENDS a, b] [COMPILED_IN c d] [SHARED_LIBRARIES]
# [ANY_MACHINE]) COMPILED_IN: notices of what leaves code in its binaries. SHARED_LIBRARIES: what its
# programs are linked to goes to what it depends on.
macro(halfspace_package component)
  cmake_parse_arguments(package "SHARED_LIBRARIES;ANY_MACHINE" "NAME;SECTION;CONTENT;DEPENDS" "COMPILED_IN" ${ARGN})
  string(TOUPPER ${component} COMPONENT)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package_NAME})
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_SECTION ${package_SECTION})
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_DEPENDS "${package_DEPENDS}")
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_SHLIBDEPS ${package_SHARED_LIBRARIES})
  set(CPACK_COMPONENT_${COMPONENT}_DESCRIPTION "\
libhalfspace finds the contacts between convex polygons or polyhedra, computes
the contact forces and moves the blocks in time.

This package holds ${package_CONTENT}.")
  set(CPACK_HALFSPACE_${COMPONENT}_COMPILED_IN ${package_COMPILED_IN})
  if(package_ANY_MACHINE)
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_ARCHITECTURE all)
  endif()
endmacro()

set(library libhalfspace${HALFSPACE_SOVERSION})
halfspace_package(library NAME ${library} SECTION libs CONTENT "the shared library" COMPILED_IN eigen SHARED_LIBRARIES)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)
set(this_library "${library} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
halfspace_package(development NAME libhalfspace-dev SECTION libdevel DEPENDS "${this_library}, libqhull-dev"
  CONTENT "headers, the static library, Fortran modules,\nRust crates and the Box2D adapter" COMPILED_IN eigen)
if(HALFSPACE_BUILD_BOX2D)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS libbox2d-dev)
endif()
if(HALFSPACE_BUILD_CLI)
  halfspace_package(tools NAME halfspace-tools SECTION science DEPENDS "${this_library}" SHARED_LIBRARIES
    CONTENT "the command halfspace, which runs scene files, and its viewer" COMPILED_IN cli11 three tomlplusplus)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)  # it has the viewer's library
  set(scene_library libhalfspace-scene${HALFSPACE_SOVERSION})
  halfspace_package(scene NAME ${scene_library} SECTION libs DEPENDS "${this_library}" SHARED_LIBRARIES
    CONTENT "the library of scene files, which Python loads" COMPILED_IN tomlplusplus)
  set(CPACK_DEBIAN_SCENE_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    ", ${scene_library} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  set(scene_for_python ", ${scene_library} (>= ${PROJECT_VERSION})")
endif()
if(HALFSPACE_BUILD_PYTHON)
  halfspace_package(python NAME python3-halfspace SECTION python ANY_MACHINE
    DEPENDS "${library} (>= ${PROJECT_VERSION})${scene_for_python}, python3 (>= 3.9), python3-numpy" CONTENT "the Python package")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, halfspace-tools")
  # Byte code comes and goes with the package.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/bindings/python/debian/postinst
    ${PROJECT_SOURCE_DIR}/bindings/python/debian/prerm)
endif()
if(HALFSPACE_BUILD_LAMMPS)
  halfspace_package(lammps NAME halfspace-lammps SECTION science DEPENDS "${this_library}" SHARED_LIBRARIES
    CONTENT "lmp_halfspace, which is LAMMPS with fix halfspace" COMPILED_IN lammps)
endif()
if(HALFSPACE_BUILD_DOCS)
  halfspace_package(documentation NAME libhalfspace-doc SECTION doc ANY_MACHINE CONTENT "the guide, examples and the reference")
endif()
include(CPack)
