#pragma once

#include <cstdint>

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// That of an outline without vertices.
Topology no_topology();

/// The topologies of a world's blocks; equal ones are stored once.
class Topologies {
 public:
  explicit Topologies(Memory* memory)
      : indices_(memory), kept_(memory), views_(memory), by_hash_(memory), is_held_(memory) {}

  /// Adds a block's topology, or finds an equal one. Returns its index.
  std::int32_t add(const Topology& topology);
  /// One block more uses one that is here.
  void add_user(std::int32_t which) { ++kept_[std::size_t(which)].users; }
  /// Holds all topologies of another world, until end_holding() lets go of those without users.
  void hold_all_of(const Topologies& other);
  void end_holding();
  /// Is a topology the one made from the loops of its faces, of one closed surface?
  bool is_sound(const Topology& topology) const;
  /// One block fewer uses it.
  void release(std::int32_t which);
  /// Valid until the next one is added or released.
  const Topology& operator[](std::int32_t which) const { return views_[std::size_t(which)]; }

  /// False for data of a damaged snapshot. If true, each topology is the one made from the loops of its
  /// faces, of one closed surface, so that walks along it return to their start.
  bool is_consistent() const;
  bool has(std::int32_t which) const { return users(which) > 0; }
  /// The number of blocks that use it.
  std::int32_t users(std::int32_t which) const {
    return which >= 0 && std::size_t(which) < kept_.size() ? kept_[std::size_t(which)].users : 0;
  }
  /// All indices are below this.
  std::size_t size() const { return kept_.size(); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(indices_, kept_);
    if constexpr (Archive::reads) {
      are_sound_ = false;
      find_anew();
    }
  }

 private:
  struct Kept {
    std::int64_t first = 0;  // in indices_
    std::int32_t vertices = 0;
    std::int32_t edges = 0;
    std::int32_t faces = 0;
    std::int32_t users = 0;  // 0: free for another topology
    std::uint64_t hash = 0;

    std::int64_t length() const;
  };

  bool lies_within(const Kept& kept) const;
  std::int32_t find(std::uint64_t hash, const Topology& topology, std::int64_t length) const;
  bool view_anew();
  void find_anew();

  Array<std::int32_t> indices_;
  Array<Kept> kept_;
  Array<Topology> views_;          // of kept_; empty after reading a damaged snapshot
  Array<std::int32_t> by_hash_;    // indices of those in use, sorted by hash
  Array<std::uint8_t> is_held_;    // during hold_all_of(), per index that the other world had
  mutable bool are_sound_ = true;  // as far as is known
};

}  // namespace halfspace
