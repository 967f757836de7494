#include "hosts/lammps_run.h"

// The same on more processes than there are processors, with each law, and over restarts.

using namespace halfspace_test;

TEST_CASE("LAMMPS keeps the bits on 3 and 8 processes", "[hosts]") {
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 1, 2)];
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  const bool is_plane = GENERATE(true, false);
  const int processes = GENERATE(3, 8);
  INFO(of.name << ", kind " << kind << (is_plane ? ", plane, " : ", space, ") << processes << " processes");
  const Snapshot start = is_plane ? heap_in_plane(of, kind) : heap_in_space(of, kind);
  const LammpsRun lammps(start, is_plane);
  lammps.run(processes, lammps.box() + lammps.fix() + "run 4000\n");
  check_end(start, 4000, lammps.end());
}

TEST_CASE("bonds by laws break in LAMMPS as in one process", "[hosts]") {
  const Snapshot start = wall_in_plane();
  const LammpsRun lammps(start, true);
  lammps.run(3, lammps.box() + lammps.fix() + "run 8000\n");
  check_end(start, 8000, lammps.end());
}

TEST_CASE("LAMMPS goes on from a restart file on another number of processes", "[hosts]") {
  const bool is_plane = GENERATE(true, false);
  const int processes = GENERATE(1, 3);
  INFO((is_plane ? "plane, " : "space, ") << processes << " processes");
  const Snapshot start = is_plane ? heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID)
                                  : heap_in_space(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const LammpsRun lammps(start, is_plane);
  // Restart files within the run, and after it; then the run goes on, without and with a setup.
  lammps.run(2, lammps.box() + lammps.fix() + "restart 700 " + lammps.file("middle.*") +
                    "\nrun 1000\nwrite_restart " + lammps.file("restart") + "\nrun 500 pre no\nrun 500\n");
  check_end(start, 2000, lammps.end());
  lammps.run(processes, "newton off\ncomm_style tiled\nread_restart " + lammps.file("restart") + "\n" +
                            lammps.fix() + "run 1000\n");
  check_end(start, 2000, lammps.end());
  lammps.run(processes, "newton off\ncomm_style tiled\nread_restart " + lammps.file("middle.700") + "\n" +
                            lammps.fix() + "run 1300\n");
  check_end(start, 2000, lammps.end());
}

TEST_CASE("the 6-way pattern of LAMMPS keeps the bits", "[hosts]") {
  const Snapshot start = heap_in_space(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const LammpsRun lammps(start, false);
  lammps.run(8, "processors 4 2 1\n" + lammps.box() + "comm_style brick\nfix blocks all halfspace " +
                    lammps.file("start.hsw") + " save " + lammps.file("end.hsw") + "\nrun 2000\n");
  check_end(start, 2000, lammps.end());
}
