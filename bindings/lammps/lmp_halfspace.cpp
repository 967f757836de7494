// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence. `lmp` with the style `fix halfspace`; the arguments are those of lmp.

#include <mpi.h>

#include "fix_halfspace.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    halfspace_lammps::add_fix_style(lammps);
    lammps.input->file();
  }
  MPI_Finalize();
}
