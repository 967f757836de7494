// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.
#include "fix_halfspace.h"

#include <algorithm>
#include <climits>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "library.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace halfspace_lammps {

namespace {

/// Numbers per copy that are carried at once: at least those of its loads. Longer records go in chunks.
constexpr int chunk_length = 64;
/// Numbers per atom: orientation x y z w, angular velocity, torque.
constexpr int column_count = 10;
constexpr int energy_count = 7;

LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* lammps, int narg, char** arg) {
  return new FixHalfspace(lammps, narg, arg);
}

}  // namespace

void add_fix_style(LAMMPS_NS::LAMMPS& lammps) { (*lammps.modify->fix_map)["halfspace"] = make_fix; }

FixHalfspace::FixHalfspace(LAMMPS_NS::LAMMPS* lammps, int narg, char** arg) : Fix(lammps, narg, arg) {
  if (narg != 4 && !(narg == 6 && std::string(arg[4]) == "save"))
    error->all(FLERR, std::string("Illegal fix halfspace command: fix ID all halfspace START [save END]"));
  if (igroup != 0) error->all(FLERR, std::string("fix halfspace moves all atoms; its group is ") + arg[1]);
  if (narg == 6) save_name_ = arg[5];
  make_place_for_save();
  time_integrate = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = energy_count;
  global_freq = 1;
  extvector = 1;
  peratom_flag = 1;
  size_peratom_cols = column_count;
  peratom_freq = 1;
  comm_forward = chunk_length;
  maxexchange_dynamic = 1;

  share_ = std::make_unique<Share>(lammps, std::string(arg[3]));
  if (atom->natoms == 0) create_atoms();
  grow_arrays(atom->nmax);
  atom->add_callback(LAMMPS_NS::Atom::GROW);
}

/// A run that cannot save its end is refused before it begins.
void FixHalfspace::make_place_for_save() const {
  if (save_name_.empty()) return;
  const std::filesystem::path path = std::filesystem::absolute(save_name_);
  std::error_code fault;
  std::filesystem::create_directories(is_snapshot(save_name_) ? path.parent_path() : path, fault);
  if (fault) error->one(FLERR, "fix halfspace: cannot write " + save_name_ + ": " + fault.message());
}

FixHalfspace::~FixHalfspace() {
  atom->delete_callback(id, LAMMPS_NS::Atom::GROW);
  memory->destroy(array_atom);
}

int FixHalfspace::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_EXCHANGE | POST_NEIGHBOR | FINAL_INTEGRATE | POST_RUN;
}

/// Each process creates those in its part of the box.
void FixHalfspace::create_atoms() {
  has_atoms_ = true;
  std::vector<PlacedRecord> blocks = share_->dealt();
  std::vector<tagint> tags;
  tags.reserve(blocks.size() + 1);  // without ids, LAMMPS would choose some
  std::vector<double> positions;
  for (const PlacedRecord& block : blocks) {
    tags.push_back(block.tag);
    positions.insert(positions.end(), block.position.begin(), block.position.end());
  }
  const std::vector<int> types(tags.size(), 1);
  lammps_create_atoms(lmp, int(tags.size()), tags.data(), types.data(), positions.data(), nullptr, nullptr,
                      0);
  require_atoms();
  const std::set<tagint> here(atom->tag, atom->tag + atom->nlocal);
  for (PlacedRecord& block : blocks)
    if (here.count(block.tag) > 0) share_->record_of(block.tag) = std::move(block.record);
}

void FixHalfspace::init() {
  constexpr int minimize = 2;
  if (update->whichflag == minimize)
    error->all(FLERR, std::string("fix halfspace moves blocks by run; minimize has no forces of its own"));
  const hs_world_report report = share_->report();
  if (std::strcmp(update->unit_style, "si") != 0)
    error->all(FLERR, std::string("fix halfspace needs units si; they are ") + update->unit_style);
  require_atoms();
  if (domain->xperiodic || domain->yperiodic || (domain->dimension == 3 && domain->zperiodic))
    error->all(FLERR, std::string("fix halfspace needs boundaries that are not periodic"));
  if (report.dimension != domain->dimension)
    error->all(FLERR, "fix halfspace: the world's dimension is " + std::to_string(report.dimension) +
                          ", that of the box " + std::to_string(domain->dimension));
  for (int i = 0; modify->fix[i] != this; ++i)
    if (std::string(modify->fix[i]->style) == "balance")
      error->all(FLERR,
                 std::string("fix halfspace packs blocks before they migrate: put fix balance after it"));
  update->dt = report.time_step;
  neighbor->build_once = 1;
  load_length_ = std::size_t(share_->info().load_length);
  is_stale_ = true;
  if (!share_->is_divided()) {
    places_.resize(std::size_t(atom->nlocal));
    for (int i = 0; i < atom->nlocal; ++i) places_[std::size_t(i)] = share_->place_of(atom->tag[i]);
    write_atoms();
  }
  prepare_exchange();
}

/// All blocks must be atoms that this fix has created, or read from a restart file.
void FixHalfspace::require_atoms() const {
  if (!has_atoms_)
    error->all(FLERR, "fix halfspace: the box had " + std::to_string(atom->natoms) +
                          " atoms before the fix, which creates those of its blocks: use one fix halfspace, "
                          "under its old ID after read_restart, and delete_atoms group all before another");
  const hs_share_info info = share_->info();
  const std::int64_t free_count = info.whole_count - info.everywhere_count;
  if (atom->natoms != free_count)
    error->all(FLERR, "fix halfspace: of " + std::to_string(free_count) + " blocks " +
                          std::to_string(atom->natoms) + " are in the box");
}

void FixHalfspace::pre_exchange() {
  prepare_exchange();
  comm->setup();
}

/// Copies must reach as far as the halo, and messages must hold the longest record.
void FixHalfspace::prepare_exchange() {
  comm->cutghostuser = std::max(comm->cutghostuser, share_->halo());
  longest_record_ = share_->pack();
  maxexchange = int(longest_record_) + 1;
}

void FixHalfspace::setup_post_neighbor() { divide(); }

void FixHalfspace::setup(int) {
  share_->check(hs_world_begin(share_->handle()));
  carry_loads();
  write_loads();
  share_->check(hs_world_end_begin(share_->handle()));
  write_atoms();
}

void FixHalfspace::initial_integrate(int) {
  plan_ = share_->planned(is_stale_);
  if (plan_.needs_list || plan_.needs_assembly) next_reneighbor = update->ntimestep;
}

/// The plan made it necessary, or a restart file, or a balance of load.
void FixHalfspace::post_neighbor() {
  const bool needed_list = plan_.needs_list;
  divide();
  plan_ = share_->planned();
  if (needed_list || plan_.needs_list) plan_ = share_->with_new_list();
}

void FixHalfspace::final_integrate() {
  if (plan_.refusal != HS_OK)
    error->all(FLERR, std::string("fix halfspace: ") + hs_status_string(hs_status(plan_.refusal)));
  share_->check(hs_world_move(share_->handle()));
  carry_loads();
  write_loads();
  share_->check(hs_world_end_step(share_->handle()));
  write_atoms();
}

/// Assembles the share of the atoms that are here.
void FixHalfspace::divide() {
  const std::size_t own_count = std::size_t(atom->nlocal), copy_count = std::size_t(atom->nghost);
  loads_of_copies_.assign(copy_count * load_length_, 0);
  const int chunks = int((longest_record_ + chunk_length - 1) / chunk_length);
  for (chunk_ = 0; chunk_ < chunks; ++chunk_) comm->forward_comm_fix(this);
  chunk_ = -1;
  own_.resize(own_count);
  copies_.resize(copy_count);
  for (std::size_t i = 0; i < own_count; ++i) own_[i] = key_of(atom->tag[i]);
  for (std::size_t i = 0; i < copy_count; ++i) copies_[i] = key_of(atom->tag[own_count + i]);
  require_no_lost_atoms();
  share_->assemble(own_, copies_);
  if (share_->info().lost_pairs > 0)
    error->one(FLERR, std::string("fix halfspace: copies do not reach far enough"));
  places_.resize(own_count);
  for (std::size_t i = 0; i < own_count; ++i) places_[i] = share_->place_of(atom->tag[i]);
  is_stale_ = false;
}

/// LAMMPS drops atoms that leave a fixed box, and says so later.
void FixHalfspace::require_no_lost_atoms() const {
  LAMMPS_NS::bigint count = atom->nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (count != atom->natoms)
    error->all(FLERR, "fix halfspace: " + std::to_string(atom->natoms - count) + " of " +
                          std::to_string(atom->natoms) + " blocks have left the box");
}

void FixHalfspace::carry_loads() {
  comm->forward_comm_fix(this, int(load_length_));
  share_->check(hs_world_set_loads(share_->handle(), copies_.data(), std::int64_t(copies_.size()),
                                   loads_of_copies_.data()));
}

/// Forces and torques of contacts.
void FixHalfspace::write_loads() {
  std::vector<double> loads(own_.size() * load_length_);
  share_->check(hs_world_get_loads(share_->handle(), own_.data(), std::int64_t(own_.size()), loads.data()));
  const int dimension = domain->dimension;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const double* const load = loads.data() + i * load_length_;
    double *const f = atom->f[i], *const torque = array_atom[i] + 7;
    std::fill_n(f, 3, 0);
    std::fill_n(torque, 3, 0);
    std::copy_n(load, dimension, f);
    if (dimension == 3)
      std::copy_n(load + 3, 3, torque);
    else
      torque[2] = load[2];
  }
}

/// Positions, velocities and turns.
void FixHalfspace::write_atoms() {
  const std::vector<hs_pose> poses = share_->poses();
  std::vector<double> motions(6 * poses.size());
  const auto view = [&](int first) {
    double* const x = motions.data() + first;
    return hs_mutable_view{x, x + 1, x + 2, 6 * sizeof(double), std::int64_t(poses.size())};
  };
  if (!poses.empty()) share_->check(hs_world_get_velocities(share_->handle(), view(0), view(3)));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const hs_pose& pose = poses[places_[i]];
    const double* const motion = motions.data() + 6 * places_[i];
    std::copy_n(pose.position, 3, atom->x[i]);
    std::copy_n(motion, 3, atom->v[i]);
    std::copy_n(pose.rotation, 4, array_atom[i]);
    std::copy_n(motion + 3, 3, array_atom[i] + 4);
  }
}

void FixHalfspace::grow_arrays(int count) {
  memory->grow(array_atom, count, column_count, "halfspace:array_atom");
}

int FixHalfspace::pack_exchange(int i, double* buffer) {
  const Record record = share_->taken(atom->tag[i]);
  buffer[0] = double(record.size());
  std::copy(record.begin(), record.end(), buffer + 1);
  return 1 + int(record.size());
}

int FixHalfspace::unpack_exchange(int i, double* buffer) {
  const int length = int(buffer[0]);
  if (length > 0) share_->record_of(atom->tag[i]).assign(buffer + 1, buffer + 1 + length);
  return 1 + length;
}

int FixHalfspace::pack_forward_comm(int count, int* list, double* buffer, int, int*) {
  double* out = buffer;
  for (int k = 0; k < count; ++k) {
    const int i = list[k];
    if (chunk_ >= 0) {
      const Record& record = share_->record_of(atom->tag[i]);
      const std::size_t begin = std::min(record.size(), std::size_t(chunk_) * chunk_length);
      const std::size_t length = std::min<std::size_t>(record.size() - begin, chunk_length);
      std::copy_n(record.begin() + std::ptrdiff_t(begin), length, out);
      std::fill(out + length, out + chunk_length, 0);
      out += chunk_length;
    } else {
      if (i < atom->nlocal)
        share_->check(hs_world_get_loads(share_->handle(), &own_[std::size_t(i)], 1, out));
      else
        std::copy_n(loads_of_copies_.data() + std::size_t(i - atom->nlocal) * load_length_, load_length_,
                    out);
      out += load_length_;
    }
  }
  return int(out - buffer);
}

void FixHalfspace::unpack_forward_comm(int count, int first, double* buffer) {
  if (chunk_ < 0) {
    std::copy_n(buffer, std::size_t(count) * load_length_,
                loads_of_copies_.data() + std::size_t(first - atom->nlocal) * load_length_);
    return;
  }
  for (int k = 0; k < count; ++k) {
    const double* const in = buffer + k * chunk_length;
    Record& record = share_->record_of(atom->tag[first + k]);
    if (chunk_ == 0) record.resize(1 + (std::size_t(in[0]) + sizeof(double) - 1) / sizeof(double));
    const std::size_t begin = std::min(record.size(), std::size_t(chunk_) * chunk_length);
    std::copy_n(in, std::min<std::size_t>(record.size() - begin, chunk_length),
                record.begin() + std::ptrdiff_t(begin));
  }
}

double FixHalfspace::compute_vector(int k) {
  const hs_world_report report = share_->report();
  const hs_energy& energy = report.energy;
  const double total = energy.outer_work + energy.residual,
               strain = energy.strain + report.block_strain_energy;
  const double energies[energy_count] = {
      energy.kinetic, energy.gravity + report.water_energy,
      strain,         total - energy.kinetic - energy.gravity - report.water_energy - strain,
      total,          energy.outer_work,
      energy.residual};
  double sum = energies[k];
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return share_->is_divided() ? sum : energies[k];
}

void FixHalfspace::write(const std::string& name, const Bytes& snapshot) const {
  std::ofstream file(name, std::ios::binary);
  if (!file.write(snapshot.data(), std::streamsize(snapshot.size())).flush())
    error->one(FLERR, "fix halfspace: cannot write " + name);
}

void FixHalfspace::post_run() {
  if (save_name_.empty()) return;
  if (!is_snapshot(save_name_)) return write(share_name(save_name_, comm->me), share_->saved());
  const Bytes snapshot = share_->joined();
  if (comm->me == 0) write(save_name_, snapshot);
}

/// The whole world.
void FixHalfspace::write_restart(FILE* file) {
  const Bytes snapshot = share_->joined();
  if (comm->me != 0) return;
  const std::uint64_t size = snapshot.size();
  if (size > INT_MAX - sizeof size)
    error->one(FLERR,
               "fix halfspace: a world of " + std::to_string(size) + " bytes is too long for a restart file");
  const int all = int(size + sizeof size);
  fwrite(&all, sizeof all, 1, file);
  fwrite(&size, sizeof size, 1, file);
  fwrite(snapshot.data(), 1, size, file);
}

void FixHalfspace::restart(char* bytes) {
  has_atoms_ = true;
  std::uint64_t size = 0;
  std::memcpy(&size, bytes, sizeof size);
  share_ = std::make_unique<Share>(lmp, Bytes(bytes + sizeof size, bytes + sizeof size + size));
}

}  // namespace halfspace_lammps
