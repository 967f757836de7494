#include "hosts/lammps_run.h"

// LAMMPS moves blocks with the bits of one process.

using namespace halfspace_test;

TEST_CASE("LAMMPS keeps the bits", "[hosts]") {
  const bool is_plane = GENERATE(true, false);
  const int processes = GENERATE(1, 2);
  INFO((is_plane ? "plane" : "space") << ", " << processes << " processes");
  const Snapshot start = is_plane ? heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID)
                                  : heap_in_space(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const LammpsRun lammps(start, is_plane);
  lammps.run(processes, lammps.box() + lammps.fix() + "run 2000\n");
  check_end(start, 2000, lammps.end());
}

TEST_CASE("energies of LAMMPS add up to those of the whole world", "[hosts]") {
  const Snapshot start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_AFFINE);
  const LammpsRun lammps(start, true);
  std::string energies;
  for (int i = 1; i <= 7; ++i) energies += " $(f_blocks[" + std::to_string(i) + "]:%.17g)";
  lammps.run(2, lammps.box() + lammps.fix() + "run 2000\nprint \"" + energies + "\" file " +
                    lammps.file("energies") + "\n");

  const Context context = make_context();
  const World whole = restored(context.get(), start);
  require_ok(hs_world_step(whole.get(), 2000), context.get());
  const hs_world_report report = report_of(whole.get());
  const hs_energy& energy = report.energy;
  const double losses = energy.friction_loss + energy.contact_damping_loss + energy.local_damping_loss +
                        energy.mass_damping_loss + report.block_damping_loss;
  const double strain = energy.strain + report.block_strain_energy;
  const double total = energy.kinetic + energy.gravity + strain + losses;
  const double expected[] = {energy.kinetic, energy.gravity,    strain,         losses,
                             total,          energy.outer_work, energy.residual};
  std::ifstream file(lammps.file("energies"));
  for (const double value : expected) {
    double found = 0;
    file >> found;
    CHECK(std::abs(found - value) <= 1e-12 * std::abs(total));
  }
}
