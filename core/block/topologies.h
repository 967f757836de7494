#pragma once

#include <cstdint>

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// The topologies of all blocks of a world, each kept once however many blocks have it.
class Topologies {
 public:
  explicit Topologies(Memory* memory) : indices_(memory), kept_(memory), views_(memory), by_hash_(memory) {}

  /// Takes a block's topology in, or finds it here. Returns where.
  std::int32_t add(const Topology& topology);
  /// One block less has it.
  void release(std::int32_t which);
  /// Stays where it is until the next one is added or released.
  const Topology& operator[](std::int32_t which) const { return views_[std::size_t(which)]; }

  /// False for what cannot be, after reading a snapshot: each topology is the one that its faces' loops have,
  /// and these are of one closed surface, so that who walks along it comes back.
  bool is_consistent() const;
  bool has(std::int32_t which) const { return users(which) > 0; }
  /// How many blocks have it.
  std::int32_t users(std::int32_t which) const {
    return which >= 0 && std::size_t(which) < kept_.size() ? kept_[std::size_t(which)].users : 0;
  }
  /// All there are are below this.
  std::size_t size() const { return kept_.size(); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(indices_, kept_);
    if constexpr (Archive::reads) find_anew();
  }

 private:
  struct Kept {
    std::int64_t first = 0;  // in indices_
    std::int32_t vertices = 0;
    std::int32_t edges = 0;
    std::int32_t faces = 0;
    std::int32_t users = 0;  // 0: free for another
    std::uint64_t hash = 0;

    std::int64_t length() const;
  };

  bool lies_within(const Kept& kept) const;
  bool is_of_one_surface(const Topology& topology) const;
  std::int32_t find(std::uint64_t hash, const Topology& topology, std::int64_t length) const;
  void find_anew();

  Array<std::int32_t> indices_;
  Array<Kept> kept_;
  Array<Topology> views_;        // of kept_; empty after reading what cannot be
  Array<std::int32_t> by_hash_;  // those in use, sorted: the others are free
};

}  // namespace halfspace
