// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.
#pragma once

#include <memory>
#include <string>

#include "fix.h"
#include "share.h"

namespace halfspace_lammps {

/// `fix ID all halfspace START [save END]`: moves the blocks of a world, which are atoms, with the bits of
/// hs_world_step().
///
/// LAMMPS decides which process owns an atom and has copies of it. In the steps whose plan needs it, atoms
/// change processes with their records, copies get theirs, and the share is assembled again.
class FixHalfspace : public LAMMPS_NS::Fix {
 public:
  FixHalfspace(LAMMPS_NS::LAMMPS* lammps, int narg, char** arg);
  ~FixHalfspace() override;

  int setmask() override;
  void init() override;
  void setup_post_neighbor() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_exchange() override;
  void post_neighbor() override;
  void final_integrate() override;
  void post_run() override;

  /// Energies over all processes, J: kinetic, gravity, strain, losses, their total, outer work, residual.
  double compute_vector(int k) override;

  void grow_arrays(int count) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_forward_comm(int count, int* list, double* buffer, int, int*) override;
  void unpack_forward_comm(int count, int first, double* buffer) override;
  void write_restart(FILE* file) override;
  void restart(char* bytes) override;

 private:
  void make_place_for_save() const;
  void create_atoms();
  void require_atoms() const;
  void require_no_lost_atoms() const;
  void prepare_exchange();
  void divide();
  void carry_loads();
  void write_loads();
  void write_atoms();
  void write(const std::string& name, const Bytes& snapshot) const;

  std::unique_ptr<Share> share_;
  std::string save_name_;
  hs_share_plan plan_{};
  bool has_atoms_ = false;  // created by this fix, or of its restart file
  bool is_stale_ = true;    // atoms may have changed processes since the last assembly
  int chunk_ = -1;          // of the records that copies receive; -1: they receive loads
  std::size_t longest_record_ = 0;
  std::size_t load_length_ = 0;
  std::vector<std::size_t> places_;  // of own atoms among the blocks of the share
  Keys own_;                         // of own atoms
  Keys copies_;
  std::vector<double> loads_of_copies_;
};

void add_fix_style(LAMMPS_NS::LAMMPS& lammps);

}  // namespace halfspace_lammps
