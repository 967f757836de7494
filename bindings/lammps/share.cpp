// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.
#include "share.h"

#include <algorithm>
#include <climits>
#include <cstring>
#include <numeric>

#include "error.h"

namespace halfspace_lammps {

namespace {

int rank_in(MPI_Comm world) {
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  return rank;
}

hs_packed packed(std::int64_t key, std::int32_t role) { return {key, nullptr, 0, role, 0}; }

/// Lists of all processes, one after the other, on the first one.
template <class T>
std::vector<T> gathered(const std::vector<T>& own, MPI_Comm world) {
  int ranks = 0, size = int(own.size() * sizeof(T));
  MPI_Comm_size(world, &ranks);
  std::vector<int> sizes(static_cast<std::size_t>(ranks)), begins(sizes.size());
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  std::exclusive_scan(sizes.begin(), sizes.end(), begins.begin(), 0);
  std::vector<T> all(rank_in(world) == 0 ? std::size_t(begins.back() + sizes.back()) / sizeof(T) : 0);
  MPI_Gatherv(own.data(), size, MPI_BYTE, all.data(), sizes.data(), begins.data(), MPI_BYTE, 0, world);
  return all;
}

}  // namespace

Share::Share(LAMMPS_NS::LAMMPS* lammps) : Pointers(lammps) {
  if (hs_context_create(nullptr, &context_) != HS_OK)
    error->one(FLERR, std::string("fix halfspace: no memory"));
}

Share::Share(LAMMPS_NS::LAMMPS* lammps, const Bytes& snapshot) : Share(lammps) {
  world_ = restored(snapshot);
  look_at_blocks();
}

Share::~Share() {
  hs_world_destroy(world_);
  hs_context_destroy(context_);
}

void Share::check(hs_status status) const {
  if (status != HS_OK) error->one(FLERR, std::string("fix halfspace: ") + hs_context_last_error(context_));
}

void Share::look_at_blocks() {
  std::int64_t count = 0;
  (void)hs_world_get_keys(world_, nullptr, 0, &count);
  keys_.resize(std::size_t(count));
  roles_.resize(keys_.size());
  check(hs_world_get_keys(world_, keys_.data(), count, nullptr));
  check(hs_world_get_roles(world_, roles_.data(), count, nullptr));
}

hs_world_report Share::report() const {
  hs_world_report report;
  check(hs_world_get_report(world_, &report, sizeof report));
  return report;
}

hs_share_info Share::info() const {
  hs_share_info info;
  check(hs_world_get_share_info(world_, &info, sizeof info));
  return info;
}

std::size_t Share::place_of(tagint tag) const {
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), key_of(tag));
  if (found == keys_.end() || *found != key_of(tag))
    error->one(FLERR, "fix halfspace: atom " + std::to_string(tag) + " is no block of the world");
  return std::size_t(found - keys_.begin());
}

Keys Share::keys_with(std::int32_t role) const {
  Keys found;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (roles_[i] == role) found.push_back(keys_[i]);
  return found;
}

std::vector<hs_pose> Share::poses() const {
  std::vector<hs_pose> poses(keys_.size());
  check(hs_world_get_poses(world_, poses.data(), std::int64_t(poses.size()), nullptr));
  return poses;
}

hs_share_plan Share::combined(const hs_share_plan& own, MPI_Comm world) {
  const std::int32_t ours[] = {own.needs_list, own.needs_assembly, -own.refusal};
  std::int32_t all[3];
  MPI_Allreduce(ours, all, 3, MPI_INT32_T, MPI_MAX, world);
  return {all[0], all[1], -all[2], 0};
}

hs_share_plan Share::planned(bool is_stale) {
  hs_share_plan own;
  check(hs_world_plan_motion(world_, &own));
  own.needs_assembly |= std::int32_t(is_stale);
  return combined(own, world);
}

hs_share_plan Share::with_new_list() {
  hs_share_plan own;
  check(hs_world_renew_list(world_, &own));
  return combined(own, world);
}

double Share::halo() const {
  double halo = std::max(info().halo, halo_of_start_);
  MPI_Allreduce(MPI_IN_PLACE, &halo, 1, MPI_DOUBLE, MPI_MAX, world);
  return halo;
}

hs_world* Share::restored(const Bytes& snapshot) const {
  hs_world* world = nullptr;
  check(hs_world_restore(context_, snapshot.data(), snapshot.size(), &world));
  return world;
}

Bytes Share::saved(const hs_world* world) const {
  std::size_t size = 0;
  (void)hs_world_save(world, nullptr, 0, &size);
  Bytes snapshot(size);
  check(hs_world_save(world, snapshot.data(), size, &size));
  return snapshot;
}

void Share::broadcast(Bytes& bytes) const {
  std::int64_t size = std::int64_t(bytes.size());
  MPI_Bcast(&size, 1, MPI_INT64_T, 0, world);
  bytes.resize(std::size_t(size));
  MPI_Bcast(bytes.data(), int(size), MPI_BYTE, 0, world);
}

std::vector<Record> Share::packed_own(const Keys& own) const {
  const std::int64_t count = std::int64_t(own.size());
  std::vector<std::size_t> ends(own.size());
  std::size_t size = 0, begin = 0;
  (void)hs_world_pack(world_, own.data(), count, 1, nullptr, 0, nullptr, &size);
  Bytes bytes(size);
  check(hs_world_pack(world_, own.data(), count, 1, bytes.data(), size, ends.data(), &size));
  std::vector<Record> records;
  for (std::size_t i = 0; i < own.size(); begin = ends[i++]) {
    const std::size_t length = ends[i] - begin;
    records.emplace_back(1 + (length + sizeof(double) - 1) / sizeof(double));
    records.back()[0] = double(length);
    std::memcpy(records.back().data() + 1, bytes.data() + begin, length);
  }
  return records;
}

std::size_t Share::pack() {
  if (is_divided_ && records_.empty()) {
    const Keys own = keys_with(HS_ROLE_OWN);
    std::vector<Record> records = packed_own(own);
    for (std::size_t i = 0; i < own.size(); ++i) records_.emplace(tag_of(own[i]), std::move(records[i]));
  }
  std::uint64_t longest = 0;
  for (const auto& [tag, record] : records_) longest = std::max<std::uint64_t>(longest, record.size());
  MPI_Allreduce(MPI_IN_PLACE, &longest, 1, MPI_UINT64_T, MPI_MAX, world);
  return longest;
}

Record Share::taken(tagint tag) {
  const auto found = records_.find(tag);
  if (found == records_.end()) return {};
  Record record = std::move(found->second);
  records_.erase(found);
  return record;
}

hs_world* Share::assembled(std::vector<hs_packed> blocks) const {
  for (const std::int64_t key : keys_with(HS_ROLE_EVERYWHERE))
    blocks.push_back(packed(key, HS_ROLE_EVERYWHERE));
  std::sort(blocks.begin(), blocks.end(),
            [](const hs_packed& a, const hs_packed& b) { return a.key < b.key; });
  hs_world* made = nullptr;
  check(hs_world_assemble(context_, world_, blocks.data(), std::int64_t(blocks.size()), &made));
  return made;
}

void Share::assemble(const Keys& own, const Keys& copies) {
  std::vector<hs_packed> blocks;
  const auto add = [&](std::int64_t key, std::int32_t role) {
    blocks.push_back(packed(key, role));
    const auto found = records_.find(tag_of(key));
    if (found == records_.end()) return;
    blocks.back().bytes = found->second.data() + 1;
    blocks.back().size = std::size_t(found->second[0]);
  };
  for (const std::int64_t key : own) add(key, HS_ROLE_OWN);
  for (const std::int64_t key : copies) add(key, HS_ROLE_NEIGHBOR);
  hs_world* const next = assembled(std::move(blocks));
  hs_world_destroy(world_);
  world_ = next;
  is_divided_ = true;
  halo_of_start_ = 0;
  records_.clear();
  look_at_blocks();
}

Bytes Share::joined() const {
  if (!is_divided_) return saved();
  // Each record is preceded by its tag. Before the first assembly they are those that were dealt.
  std::vector<double> own;
  const auto add = [&](tagint tag, const Record& record) {
    own.push_back(double(tag));
    own.insert(own.end(), record.begin(), record.end());
  };
  if (records_.empty()) {
    const Keys keys = keys_with(HS_ROLE_OWN);
    const std::vector<Record> records = packed_own(keys);
    for (std::size_t i = 0; i < keys.size(); ++i) add(tag_of(keys[i]), records[i]);
  } else {
    for (const auto& [tag, record] : records_) add(tag, record);
  }
  std::int64_t size_of_all = std::int64_t(own.size() * sizeof(double));
  MPI_Allreduce(MPI_IN_PLACE, &size_of_all, 1, MPI_INT64_T, MPI_SUM, world);
  if (size_of_all > INT_MAX)
    error->all(FLERR, "fix halfspace: the records of all blocks have " + std::to_string(size_of_all) +
                          " bytes, too many for one process; save shares in a directory");
  const std::vector<double> all_records = gathered(own, world);
  double sums[HS_SUM_COUNT], all[HS_SUM_COUNT];
  check(hs_world_get_sums(world_, sums));
  MPI_Reduce(sums, all, HS_SUM_COUNT, MPI_DOUBLE, MPI_SUM, 0, world);
  if (rank_in(world) != 0) return {};
  std::vector<hs_packed> blocks;
  for (std::size_t at = 0; at < all_records.size();) {
    const std::size_t size = std::size_t(all_records[at + 1]);
    blocks.push_back({key_of(tagint(all_records[at])), &all_records[at + 2], size, HS_ROLE_OWN, 0});
    at += 2 + (size + sizeof(double) - 1) / sizeof(double);
  }
  hs_world* const whole = assembled(std::move(blocks));
  check(hs_world_set_sums(whole, all));
  const Bytes snapshot = saved(whole);
  hs_world_destroy(whole);
  return snapshot;
}

}  // namespace halfspace_lammps
