// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.
#pragma once

// The share of a world that a process of LAMMPS moves. Tags of atoms are keys of blocks plus 1.

#include <halfspace/halfspace.h>

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "pointers.h"

namespace halfspace_lammps {

using Bytes = std::vector<char>;
using Keys = std::vector<std::int64_t>;
using LAMMPS_NS::tagint;

/// A block on its way to another process: the number of its bytes, then the bytes.
using Record = std::vector<double>;

/// A block that is not yet on the process in whose part of the box it is.
struct PlacedRecord {
  tagint tag;
  std::array<double, 3> position;
  Record record;
};

inline tagint tag_of(std::int64_t key) { return tagint(key + 1); }
inline std::int64_t key_of(tagint tag) { return std::int64_t(tag) - 1; }

class Share : protected LAMMPS_NS::Pointers {
 public:
  /// The whole world, on each process, until it is divided.
  Share(LAMMPS_NS::LAMMPS* lammps, const Bytes& snapshot);
  /// A share without own blocks, which are to be dealt. `start`: a snapshot *.hsw, or a directory of shares.
  Share(LAMMPS_NS::LAMMPS* lammps, const std::string& start);
  ~Share() override;
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;

  bool is_divided() const { return is_divided_; }
  hs_world* handle() const { return world_; }
  hs_world_report report() const;
  hs_share_info info() const;
  /// Keys of all blocks here, in the order of hs_world_get_blocks().
  const Keys& keys() const { return keys_; }
  /// The place of a block among them. An atom that is no block is an error.
  std::size_t place_of(tagint tag) const;
  Keys keys_with(std::int32_t role) const;
  std::vector<hs_pose> poses() const;
  /// Ends the run with the text of the last error.
  void check(hs_status status) const;

  /// The blocks of the start that are in this part of the box, or at its border. Call on all processes.
  std::vector<PlacedRecord> dealt();

  /// The plan of all processes together. `is_stale`: this one has to be assembled.
  hs_share_plan planned(bool is_stale = false);
  hs_share_plan with_new_list();
  /// The distance that copies must reach, over all processes, m.
  double halo() const;

  /// Packs own blocks for an assembly, unless they have been packed since the last one. Returns the length of
  /// the longest record.
  std::size_t pack();
  Record& record_of(tagint tag) { return records_[tag]; }
  /// The record of a block that leaves, which is forgotten here.
  Record taken(tagint tag);
  /// Goes on with these own blocks and copies, from their records. Undivided, each process has them all.
  void assemble(const Keys& own, const Keys& copies);

  /// A snapshot of the whole world, on the first process.
  Bytes joined() const;
  /// A snapshot of this share.
  Bytes saved() const { return saved(world_); }

 private:
  explicit Share(LAMMPS_NS::LAMMPS* lammps);
  Bytes read(const std::string& name) const;
  Bytes settings() const;
  void add_to_start(double sums[]);
  void require_all() const;
  void make_box_hold_start() const;
  std::vector<int> processes_at(const std::array<double, 3>& place) const;
  void broadcast(Bytes& bytes) const;
  static hs_share_plan combined(const hs_share_plan& own, MPI_Comm world);
  std::vector<Record> packed_own(const Keys& own) const;
  hs_world* restored(const Bytes& snapshot) const;
  Bytes saved(const hs_world* world) const;
  hs_world* assembled(std::vector<hs_packed> blocks) const;
  void look_at_blocks();

  hs_context* context_ = nullptr;
  hs_world* world_ = nullptr;
  bool is_divided_ = false;
  Keys keys_;
  std::vector<std::int32_t> roles_;
  std::unordered_map<tagint, Record> records_;  // packed for the next assembly
  std::vector<PlacedRecord> start_;
  double halo_of_start_ = 0;  // until the first assembly
  Bytes settings_;
};

bool is_snapshot(const std::string& name);
/// The file of a share among those of a directory.
std::string share_name(const std::string& directory, int number);

}  // namespace halfspace_lammps
