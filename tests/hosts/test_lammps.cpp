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

TEST_CASE("LAMMPS reads shares and writes them", "[hosts]") {
  const bool is_plane = GENERATE(true, false);
  const int processes = GENERATE(1, 2, 3);
  INFO((is_plane ? "plane" : "space") << ", " << processes << " processes");
  const Snapshot start = is_plane ? heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID)
                                  : heap_in_space(laws_of_stiffness[2], HS_BLOCK_AFFINE);
  const LammpsRun lammps(start, is_plane);
  split(start, 3, lammps.folder(), "start");
  lammps.run(processes, lammps.box() + lammps.fix("start", "middle") + "run 1000\n");
  lammps.run(2, lammps.box() + lammps.fix("middle") + "run 500\n");
  check_end(start, 1000, joined(lammps.folder(), "middle"));
  check_end(start, 1500, lammps.end());
}

TEST_CASE("a box that follows the blocks may begin anywhere", "[hosts]") {
  const std::string box = GENERATE("0 0.1 0 0.1", "100 101 100 101");
  const Snapshot start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const LammpsRun lammps(start, true);
  lammps.run(8, lammps.box(box) + lammps.fix() + "run 500\n");
  check_end(start, 500, lammps.end());
}

TEST_CASE("LAMMPS writes a restart file before its first step", "[hosts]") {
  const Snapshot start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const LammpsRun lammps(start, true);
  split(start, 2, lammps.folder(), "start");
  lammps.run(3, lammps.box() + lammps.fix("start") + "write_restart " + lammps.file("restart") + "\n");
  lammps.run(2, "newton off\ncomm_style tiled\nread_restart " + lammps.file("restart") + "\n" +
                    lammps.fix("start") + "run 1000\n");
  check_end(start, 1000, lammps.end());
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

TEST_CASE("fix halfspace refuses worlds, files and boxes that it cannot move", "[hosts]") {
  const auto has = [](const std::string& output, const std::string& text) {
    INFO(output);
    CHECK(output.find(text) != std::string::npos);
  };
  const LammpsRun plane(heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID), true);
  const std::string fix = "fix blocks all halfspace ", start = plane.file("start.hsw"), run = "\nrun 1\n";
  has(plane.error(plane.box() + fix + plane.file("none.hsw") + run), "cannot read " + plane.file("none.hsw"));
  write_file(plane.file("damaged.hsw"), Snapshot(100));
  has(plane.error(plane.box() + fix + plane.file("damaged.hsw") + run), "hs_world_restore");
  has(plane.error(plane.box() + fix + plane.file("script") + run), "cannot read " + plane.file("script"));
  has(plane.error(plane.box() + fix + start + " keep" + run), "Illegal fix halfspace command");
  has(plane.error(plane.box() + "group some empty\nfix blocks some halfspace " + start + run),
      "its group is some");
  has(plane.error(plane.box() + "fix even all balance 500 1.0 rcb\n" + fix + start + run),
      "put fix balance after it");
  const std::string far = "units si\ndimension 2\nboundary f f p\nregion box block 30 40 30 40 -0.5 0.5\n";
  has(plane.error(far + "create_box 1 box\nmass 1 1\n" + fix + start + run), "of 80 blocks 0 are in the box");

  const std::string open = "dimension 2\nboundary f f p\nregion box block -40 40 0.2 40 -0.5 0.5\n";
  const std::string one = "create_box 1 box\nmass 1 1\n" + fix + start;
  has(plane.error("units lj\n" + open + one + run), "needs units si; they are lj");
  has(plane.error("units si\n" + open + one + "\nrun 5000\n"), "have left the box");
  has(plane.error(plane.box() + fix + start + " save /dev/null/end" + run), "cannot write /dev/null/end");
  has(plane.error(plane.box() + fix + start + "\nfix more all halfspace " + start + run),
      "use one fix halfspace");
  has(plane.error(plane.box() + fix + start + "\nminimize 1e-6 1e-6 10 10\n"), "moves blocks by run");
  has(plane.error(plane.box() + fix + start + run + "delete_atoms group all" + run),
      "of 80 blocks 0 are in the box");

  const LammpsRun space(heap_in_space(laws_of_stiffness[0], HS_BLOCK_RIGID), false);
  has(space.error(plane.box() + fix + space.file("start.hsw") + run),
      "the world's dimension is 3, that of the box 2");
  const std::string periodic = "units si\nboundary p s s\nregion box block -40 40 -40 40 -40 40\n";
  has(space.error(periodic + "create_box 1 box\nmass 1 1\n" + fix + space.file("start.hsw") + run),
      "boundaries that are not periodic");

  hs_world_def asleep = world_def();
  asleep.time_step = 1e-5;
  asleep.sleep_tolerance = 1e-3;
  Stage stage(asleep, law_of(laws_of_stiffness[0], 1e8, 0.5));
  stage.add(stage.rectangle({0, 0}, {1, 1}), HS_BLOCK_RIGID);
  const LammpsRun sleeping(saved(stage.world()), true);
  has(sleeping.error(sleeping.box() + sleeping.fix() + run), "the world has sleep, which shares cannot hold");
}
