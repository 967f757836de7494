// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.

// A run starts from a snapshot, which the first process reads, or from a directory of shares, of which each
// process reads every n-th. Blocks are dealt to the processes in whose part of the box they are.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <set>

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "share.h"

namespace halfspace_lammps {

namespace fs = std::filesystem;

namespace {

/// Lists for all processes, and those received from all.
std::vector<double> exchanged(const std::vector<std::vector<double>>& sent, MPI_Comm world) {
  std::vector<int> lengths, begins(sent.size()), to_come(sent.size()), begins_here(sent.size());
  std::vector<double> all;
  for (const std::vector<double>& list : sent) {
    lengths.push_back(int(list.size()));
    all.insert(all.end(), list.begin(), list.end());
  }
  MPI_Alltoall(lengths.data(), 1, MPI_INT, to_come.data(), 1, MPI_INT, world);
  std::exclusive_scan(lengths.begin(), lengths.end(), begins.begin(), 0);
  std::exclusive_scan(to_come.begin(), to_come.end(), begins_here.begin(), 0);
  std::vector<double> received(std::size_t(begins_here.back() + to_come.back()));
  MPI_Alltoallv(all.data(), lengths.data(), begins.data(), MPI_DOUBLE, received.data(), to_come.data(),
                begins_here.data(), MPI_DOUBLE, world);
  return received;
}

}  // namespace

bool is_snapshot(const std::string& name) { return fs::path(name).extension() == ".hsw"; }

std::string share_name(const std::string& directory, int number) {
  return (fs::path(directory) / ("share_" + std::to_string(number) + ".hsw")).string();
}

Bytes Share::read(const std::string& name) const {
  std::ifstream file(name, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) error->one(FLERR, "fix halfspace: cannot read " + name);
  return bytes;
}

Share::Share(LAMMPS_NS::LAMMPS* lammps, const std::string& start) : Share(lammps) {
  std::vector<std::string> names;
  if (is_snapshot(start)) {
    if (comm->me == 0) names.push_back(start);
  } else {
    for (int i = comm->me; i == 0 || fs::exists(share_name(start, i)); i += comm->nprocs)
      names.push_back(share_name(start, i));
  }
  double sums[HS_SUM_COUNT] = {};
  for (const std::string& name : names) {
    world_ = restored(read(name));
    look_at_blocks();
    if (comm->me == 0 && settings_.empty()) settings_ = settings();
    add_to_start(sums);
    hs_world_destroy(world_);
  }
  broadcast(settings_);
  world_ = restored(settings_);
  settings_.clear();
  check(hs_world_set_sums(world_, sums));
  look_at_blocks();
  is_divided_ = true;
  require_all();
}

/// A snapshot of a share of what is everywhere.
Bytes Share::settings() const {
  hs_world* const empty = assembled({});
  const Bytes bytes = saved(empty);
  hs_world_destroy(empty);
  return bytes;
}

/// Adds the own blocks of the present world, and its losses.
void Share::add_to_start(double sums[]) {
  double own_sums[HS_SUM_COUNT];
  check(hs_world_get_sums(world_, own_sums));
  for (int i = 0; i < HS_SUM_COUNT; ++i) sums[i] += own_sums[i];
  halo_of_start_ = std::max(halo_of_start_, info().halo);
  const Keys own = keys_with(HS_ROLE_OWN);
  const std::vector<Record> records = packed_own(own);
  const std::vector<hs_pose> poses = this->poses();
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double* const x = poses[place_of(tag_of(own[i]))].position;
    start_.push_back({tag_of(own[i]), {x[0], x[1], x[2]}, records[i]});
  }
}

void Share::require_all() const {
  const hs_share_info info = this->info();
  std::int64_t count = std::int64_t(start_.size());
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT64_T, MPI_SUM, world);
  if (count + info.everywhere_count != info.whole_count)
    error->all(FLERR, "fix halfspace: the shares hold " + std::to_string(count + info.everywhere_count) +
                          " of " + std::to_string(info.whole_count) + " blocks");
}

/// The processes that may have a place in their part of the box. At a border these are several, of which
/// LAMMPS takes one.
std::vector<int> Share::processes_at(const std::array<double, 3>& place) const {
  constexpr double rounding = 1e-9;
  std::set<int> processes;
  for (int corner = 0; corner < 8; ++corner) {
    double x[3];
    for (int k = 0; k < 3; ++k)
      x[k] = place[std::size_t(k)] + (corner >> k & 1 ? rounding : -rounding) * domain->prd[k];
    int at[3];
    processes.insert(comm->coord2proc(x, at[0], at[1], at[2]));
  }
  return {processes.begin(), processes.end()};
}

/// A shrink-wrapped box follows the blocks, so it may begin elsewhere. LAMMPS would give an atom beside it to
/// several processes, or to none.
void Share::make_box_hold_start() const {
  constexpr int shrink_wrapped = 2, minimal = 3;
  constexpr double margin = 1e-4;  // as LAMMPS has it
  double ends[6];                  // the lower ones, and those of the negative axes
  for (int k = 0; k < 3; ++k) {
    ends[k] = domain->boxlo[k];
    ends[k + 3] = -domain->boxhi[k];
    for (const PlacedRecord& block : start_) {
      ends[k] = std::min(ends[k], block.position[std::size_t(k)]);
      ends[k + 3] = std::min(ends[k + 3], -block.position[std::size_t(k)]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, ends, 6, MPI_DOUBLE, MPI_MIN, world);
  const auto follows = [](int boundary) { return boundary == shrink_wrapped || boundary == minimal; };
  for (int k = 0; k < 3; ++k) {
    const double low = ends[k], high = -ends[k + 3], beyond = margin * (high - low);
    if (follows(domain->boundary[k][0]) && low < domain->boxlo[k]) domain->boxlo[k] = low - beyond;
    if (follows(domain->boundary[k][1]) && high > domain->boxhi[k]) domain->boxhi[k] = high + beyond;
  }
  domain->set_global_box();
  domain->set_local_box();
}

std::vector<PlacedRecord> Share::dealt() {
  make_box_hold_start();
  comm->coord2proc_setup();
  std::vector<std::vector<double>> sent(std::size_t(comm->nprocs));
  for (const PlacedRecord& block : start_) {
    for (const int process : processes_at(block.position)) {
      std::vector<double>& message = sent[std::size_t(process)];
      message.push_back(double(block.tag));
      message.insert(message.end(), block.position.begin(), block.position.end());
      message.push_back(double(block.record.size()));
      message.insert(message.end(), block.record.begin(), block.record.end());
    }
  }
  start_.clear();
  const std::vector<double> received = exchanged(sent, world);
  std::vector<PlacedRecord> blocks;
  for (std::size_t at = 0; at < received.size();) {
    const double* const in = received.data() + at;
    const std::size_t length = std::size_t(in[4]);
    blocks.push_back({tagint(in[0]), {in[1], in[2], in[3]}, Record(in + 5, in + 5 + length)});
    at += 5 + length;
  }
  return blocks;
}

}  // namespace halfspace_lammps
