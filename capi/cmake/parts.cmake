# The parts that are optional, and what they need.
include(capi/cmake/optional_parts.cmake)
file(WRITE ${PROJECT_BINARY_DIR}/left_out.txt "")

# Debian's own Python, for which modules are packaged. Debian's cargo, whose compiler is the oldest that the crates are
# for, comes before others; it calls the compiler that lies beside it.
find_program(SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(SYSTEM_GFORTRAN gfortran PATHS /usr/bin NO_DEFAULT_PATH)
find_program(HALFSPACE_CARGO cargo HINTS /usr/bin)
if(HALFSPACE_CARGO)
  cmake_path(GET HALFSPACE_CARGO PARENT_PATH cargo_folder)
else()
  set(cargo_folder /usr/bin)
endif()
set(probe_folder ${PROJECT_SOURCE_DIR}/capi/cmake/probe)

# ---- what the command needs ----
halfspace_dependency(CLI11 PACKAGE libcli11-dev FIND "find_package(CLI11 REQUIRED)" LINK CLI11::CLI11
  SOURCE [[#include <CLI/Version.hpp>
int main() { return sizeof CLI11_VERSION; }]])
halfspace_dependency(toml++ PACKAGE libtomlplusplus-dev FIND "find_package(tomlplusplus REQUIRED)"
  LINK tomlplusplus::tomlplusplus SOURCE [[#include <toml++/toml.h>
int main() { toml::parse("a = 1"); }]])
halfspace_dependency(libpng PACKAGE libpng-dev FIND "find_package(PNG REQUIRED)" LINK PNG::PNG SOURCE [[#include <png.h>
int main() { png_access_version_number(); }]])
halfspace_dependency(muParser PACKAGE libmuparser-dev FIND "find_package(muparser REQUIRED)" LINK muparser::muparser
  SOURCE [[#include <muParser.h>
int main() { mu::Parser parser; }]])
halfspace_dependency(Voro++ PACKAGE voro++-dev FIND [[
find_path(VORO_INCLUDE_DIR voro++/voro++.hh REQUIRED)
find_library(VORO_LIBRARY voro++ REQUIRED)]] LINK [[${VORO_LIBRARY}]] SOURCE [[#include <voro++/voro++.hh>
int main() { voro::voronoicell().init(-1, 1, -1, 1, -1, 1); }]])
halfspace_dependency(zlib PACKAGE zlib1g-dev FIND "find_package(ZLIB REQUIRED)" LINK ZLIB::ZLIB
  SOURCE [[#include <zlib.h>
int main() { zlibVersion(); }]])
# Debian has it as libjs-three, other systems as the package `three` of npm.
find_file(HALFSPACE_THREE_JS three.min.js
  PATHS /usr/share/javascript/three /usr/share/nodejs/three/build NO_DEFAULT_PATH
  DOC "three.js, which the viewer's page contains")
halfspace_dependency(three.js PACKAGE libjs-three RUN ${CMAKE_COMMAND} -E md5sum ${HALFSPACE_THREE_JS})

# ---- what core, languages, hosts and pages need ----
halfspace_dependency(Qhull PACKAGE libqhull-dev FIND [[
find_package(Qhull QUIET NO_MODULE GLOBAL)  # GLOBAL also for who links the static library
if(TARGET Qhull::qhull_r)
  set(qhull_target Qhull::qhull_r)
else()
  set(qhull_target Qhull::qhullstatic_r)
endif()]] LINK [[${qhull_target}]] SOURCE [[extern "C" {
#include <libqhull_r/qhull_ra.h>
}
int main() { qhT state; qh_zero(&state, nullptr); }]])
halfspace_dependency(Fortran PACKAGE gfortran FIND "enable_language(Fortran)" SOURCE "int main() {}")
halfspace_dependency(Python PACKAGE python3 RUN ${SYSTEM_PYTHON} -c "import ctypes")
halfspace_dependency(Cargo PACKAGE cargo RUN ${HALFSPACE_CARGO} --version)
halfspace_dependency(Box2D PACKAGE libbox2d-dev FIND "find_package(box2d 2.4 REQUIRED)" LINK box2d::box2d
  SOURCE [[#include <box2d/box2d.h>
int main() { b2World world(b2Vec2(0, 0)); }]])
halfspace_dependency(MPI PACKAGE libopenmpi-dev RUN mpiexec --version FIND "find_package(MPI REQUIRED COMPONENTS CXX)"
  LINK MPI::MPI_CXX SOURCE [[#include <mpi.h>
int main() { MPI_Finalize(); }]])
halfspace_dependency(LAMMPS PACKAGE liblammps-dev FIND [[
find_path(LAMMPS_INCLUDE_DIR lammps.h PATH_SUFFIXES lammps REQUIRED)
find_library(LAMMPS_LIBRARY lammps REQUIRED)
include_directories(SYSTEM ${LAMMPS_INCLUDE_DIR})]] LINK [[${LAMMPS_LIBRARY}]] SOURCE [[#include <library.h>
int main() { lammps_version(nullptr); }]])
halfspace_dependency(Zoltan PACKAGE libtrilinos-zoltan-dev FIND [[
find_path(ZOLTAN_INCLUDE_DIR zoltan.h PATH_SUFFIXES trilinos REQUIRED)
find_library(ZOLTAN_LIBRARY trilinos_zoltan REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)
include_directories(SYSTEM ${ZOLTAN_INCLUDE_DIR})]] LINK MPI::MPI_CXX [[${ZOLTAN_LIBRARY}]] SOURCE [[#include <zoltan.h>
int main() { Zoltan_Initialize(0, nullptr, nullptr); }]])
halfspace_dependency(Doxygen PACKAGE doxygen RUN doxygen --version FIND "find_package(Doxygen REQUIRED)"
  SOURCE "int main() {}")

# ---- what tests and benchmarks need ----
halfspace_dependency(Catch2 PACKAGE catch2 FIND "find_package(Catch2 REQUIRED)" LINK Catch2::Catch2 SOURCE [[
#if __has_include(<catch2/catch_version_macros.hpp>)
#include <catch2/catch_version_macros.hpp>
#else
#include <catch2/catch.hpp>
#endif
int main() { return CATCH_VERSION_MAJOR; }]])
halfspace_dependency(CGAL PACKAGE libcgal-dev FIND "find_package(CGAL REQUIRED)" LINK CGAL::CGAL
  SOURCE [[#include <CGAL/version.h>
int main() { return CGAL_VERSION_NR > 0; }]])
halfspace_dependency(FCL PACKAGE libfcl-dev FIND "find_package(ccd REQUIRED)\nfind_package(fcl REQUIRED)" LINK fcl
  SOURCE [[#include <fcl/geometry/shape/box.h>
int main() { fcl::Box<double>(1, 1, 1).computeLocalAABB(); }]])
halfspace_dependency(libccd PACKAGE libccd-dev FIND "find_package(ccd REQUIRED)" LINK ccd SOURCE [[#include <ccd/ccd.h>
int main() { ccdFirstDirDefault(nullptr, nullptr, nullptr); }]])
halfspace_dependency(pkg-config PACKAGE pkg-config RUN pkg-config --version FIND "find_package(PkgConfig REQUIRED)"
  SOURCE "int main() {}")
halfspace_dependency(Bullet PACKAGE libbullet-dev FIND [[
find_package(PkgConfig REQUIRED)
pkg_check_modules(bullet_double REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(bullet_single REQUIRED IMPORTED_TARGET bullet)]] LINK PkgConfig::bullet_single
  SOURCE [[#include <btBulletDynamicsCommon.h>
int main() { btSphereShape sphere(1); }]])
halfspace_dependency(ODE PACKAGE libode-dev FIND [[
find_package(PkgConfig REQUIRED)
pkg_check_modules(ode REQUIRED IMPORTED_TARGET ode)]] LINK PkgConfig::ode SOURCE [[#include <ode/ode.h>
int main() { dInitODE(); }]])
# A folder that is left empty can still be imported; what is in it cannot.
foreach(module numpy/numpy.random matplotlib/matplotlib.pyplot vtk9/vtkmodules.vtkIOXML selenium/selenium.webdriver
        pytest/pytest.__main__ build/build.__main__ setuptools/setuptools.build_meta wheel/wheel.bdist_wheel
        venv/ensurepip.__main__)
  cmake_path(GET module PARENT_PATH name)
  cmake_path(GET module FILENAME module)
  halfspace_dependency(python3-${name} PACKAGE python3-${name} RUN ${SYSTEM_PYTHON} -c "import ${module}")
endforeach()
halfspace_dependency(python3-clang PACKAGE python3-clang RUN ${SYSTEM_PYTHON} -c
  "import clang.cindex; clang.cindex.Index.create()")
halfspace_dependency(rustdoc PACKAGE rustc RUN ${cargo_folder}/rustdoc --version)
halfspace_dependency(Rust PACKAGE rustc RUN ${cargo_folder}/rustc --crate-type=lib --emit=metadata
  -o ${PROJECT_BINARY_DIR}/probes/rust.rmeta ${probe_folder}/probe.rs)
halfspace_dependency(gfortran PACKAGE gfortran RUN ${SYSTEM_GFORTRAN} -fsyntax-only ${probe_folder}/probe.f90)
halfspace_dependency(Clippy PACKAGE rust-clippy RUN ${cargo_folder}/clippy-driver --version)
halfspace_dependency(Chromium PACKAGE chromium RUN chromium --version)
halfspace_dependency(ChromeDriver PACKAGE chromium-driver RUN chromedriver --version)
halfspace_dependency(file PACKAGE file RUN file --version)
halfspace_dependency(abidiff PACKAGE abigail-tools RUN abidiff --version)
halfspace_dependency(qemu PACKAGE qemu-user RUN qemu-x86_64 --version)
halfspace_dependency(dpkg-deb PACKAGE dpkg RUN dpkg-deb --version)
halfspace_dependency(valgrind PACKAGE valgrind RUN valgrind --version)
halfspace_dependency(ccache PACKAGE ccache RUN ccache --version)

# ---- the parts ----
set(at_first OFF)
set(fortran_at_first OFF)
if(PROJECT_IS_TOP_LEVEL)
  set(at_first AUTO)
endif()
if(PROJECT_IS_TOP_LEVEL OR CMAKE_Fortran_COMPILER)
  set(fortran_at_first AUTO)
endif()
set(hosts_at_first ${at_first})
if(CMAKE_C_FLAGS MATCHES "fsanitize")
  set(hosts_at_first OFF)
endif()

include(core/qhull.cmake)
set(hulls "")  # which tests and benchmarks need
if(halfspace_without_qhull)
  set(hulls Qhull)
endif()
halfspace_part(HALFSPACE_BUILD_CLI ${at_first} "the halfspace command" CLI11 toml++ libpng muParser Voro++ zlib)
halfspace_part(HALFSPACE_BUILD_FORTRAN ${fortran_at_first} "the Fortran modules" Fortran)
halfspace_part(HALFSPACE_BUILD_PYTHON ${at_first} "the Python package and its wheel" Python)
halfspace_part(HALFSPACE_BUILD_RUST ${at_first} "the Rust crates" Cargo)
halfspace_part(HALFSPACE_BUILD_LAMMPS ${hosts_at_first} "lmp_halfspace, which is lmp with fix halfspace (GPL 2)"
  MPI LAMMPS)
halfspace_part(HALFSPACE_BUILD_BOX2D ${at_first} "the half-space narrow phase in Box2D worlds" Box2D)
halfspace_part(HALFSPACE_BUILD_DOCS ${at_first} "the API reference, target docs" Doxygen Python)
halfspace_part(HALFSPACE_BUILD_TESTS ${at_first} "the tests" Catch2 Python pkg-config ${hulls})
halfspace_part(HALFSPACE_BUILD_BENCHMARKS ${at_first} "the benchmarks"
  Box2D CGAL libccd FCL pkg-config Bullet ODE Python python3-numpy python3-matplotlib ${hulls})

if(HALFSPACE_BUILD_TESTS)
  if(HALFSPACE_BUILD_DOCS)
    halfspace_part(HALFSPACE_BUILD_SHARES_MPI ${hosts_at_first} "the example that spreads a world over processes"
      MPI Zoltan)
  endif()
  halfspace_where_works(HALFSPACE_TEST_BINDINGS_API "tests of the C interface as data" python3-clang Rust gfortran)
  halfspace_where_works(HALFSPACE_TEST_INSTRUCTIONS "the test of counting instructions" valgrind)
  if(HALFSPACE_BUILD_CLI)
    halfspace_where_works(HALFSPACE_TEST_COMMAND "tests of the command" python3-numpy python3-vtk9 three.js)
    halfspace_where_works(HALFSPACE_TEST_VIEWER "tests of the viewer in a browser"
      three.js Chromium ChromeDriver python3-selenium python3-numpy python3-matplotlib python3-vtk9)
  endif()
  if(HALFSPACE_BUILD_PYTHON)
    halfspace_where_works(HALFSPACE_TEST_PYTHON "tests of the Python package"
      python3-numpy python3-pytest python3-matplotlib three.js)
    halfspace_where_works(HALFSPACE_TEST_WHEEL "the test of the wheel"
      python3-build python3-setuptools python3-wheel python3-venv)
  endif()
  if(HALFSPACE_BUILD_RUST)
    halfspace_where_works(HALFSPACE_TEST_RUST "tests of the Rust crates" Rust rustdoc)
    halfspace_where_works(HALFSPACE_TEST_CLIPPY "the test by clippy of the Rust crates" Clippy)
  endif()
  if(HALFSPACE_TEST_RESULTS)
    halfspace_where_works(HALFSPACE_TEST_EXACT "tests against exact arithmetic" CGAL)
    halfspace_where_works(HALFSPACE_TEST_PEERS "tests beside other engines" CGAL libccd FCL pkg-config Bullet ODE)
  endif()
  if(HALFSPACE_TEST_SLOW)
    halfspace_where_works(HALFSPACE_TEST_ABI "the test of the binary interface" abidiff)
    halfspace_where_works(HALFSPACE_TEST_OLD_PROCESSOR "the test on an old processor" qemu)
    halfspace_where_works(HALFSPACE_TEST_PACKAGES "the test of Debian packages" dpkg-deb file)
  endif()
endif()
