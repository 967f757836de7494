#include "block/topologies.h"

#include <algorithm>

#include "block/tiling.h"
#include "geometry/polyhedron/surface.h"
#include "geometry/polyhedron/topology.h"

namespace halfspace {
namespace {

/// FNV-1a over the contiguous arrays.
std::uint64_t hash_of(const std::int32_t* indices, std::int64_t length) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::int64_t i = 0; i < length; ++i) hash = (hash ^ std::uint64_t(indices[i])) * 0x100000001b3u;
  return hash;
}

}  // namespace

Topology no_topology() {
  static constexpr std::int32_t indices[2] = {};
  return topology_at(indices, 0, 0, 0);
}

std::int64_t Topologies::Kept::length() const { return topology_length(vertices, edges, faces); }

std::int32_t Topologies::find(std::uint64_t hash, const Topology& topology, std::int64_t length) const {
  const auto precedes = [&](std::int32_t which, std::uint64_t h) {
    return kept_[std::size_t(which)].hash < h;
  };
  for (auto i = std::lower_bound(by_hash_.begin(), by_hash_.end(), hash, precedes);
       i != by_hash_.end() && kept_[std::size_t(*i)].hash == hash; ++i) {
    const Kept& kept = kept_[std::size_t(*i)];
    if (kept.length() == length &&
        std::equal(topology.first_of_face, topology.first_of_face + length, indices_.data() + kept.first))
      return *i;
  }
  return -1;
}

/// Rebuilds views_; false for a damaged snapshot, which has none.
bool Topologies::view_anew() {
  views_.clear();
  for (const Kept& kept : kept_) {
    if (kept.users > 0 && !lies_within(kept)) {
      views_.clear();
      return false;
    }
    views_.push_back(kept.users > 0
                         ? topology_at(indices_.data() + kept.first, kept.vertices, kept.edges, kept.faces)
                         : Topology());
  }
  return true;
}

/// Rebuilds views_ and by_hash_.
void Topologies::find_anew() {
  by_hash_.clear();
  if (!view_anew()) return;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (kept_[i].users > 0) by_hash_.push_back(std::int32_t(i));
  }
  std::sort(by_hash_.begin(), by_hash_.end(), [&](std::int32_t i, std::int32_t j) {
    const std::uint64_t a = kept_[std::size_t(i)].hash, b = kept_[std::size_t(j)].hash;
    return a < b || (a == b && i < j);
  });
}

std::int32_t Topologies::add(const Topology& topology) {
  const std::int64_t length =
      topology_length(topology.vertex_count, topology.edge_count, topology.face_count);
  const std::uint64_t hash = hash_of(topology.first_of_face, length);
  if (const std::int32_t known = find(hash, topology, length); known >= 0) {
    ++kept_[std::size_t(known)].users;
    return known;
  }
  // Allocates first: when memory runs out, nothing has changed.
  const bool all_in_use = by_hash_.size() == kept_.size();
  const auto unused =
      all_in_use ? kept_.end()
                 : std::find_if(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.users == 0; });
  const std::size_t which = std::size_t(unused - kept_.begin());
  const std::size_t first = indices_.size(), count = std::max(kept_.size(), which + 1);
  make_room_for_one(kept_);
  make_room_for_one(views_);
  make_room_for_one(by_hash_);
  const std::int32_t* const before = indices_.data();
  indices_.insert(indices_.end(), topology.first_of_face, topology.first_of_face + length);

  kept_.resize(count);
  views_.resize(count);
  kept_[which] = {
      std::int64_t(first), topology.vertex_count, topology.edge_count, topology.face_count, 1, hash};
  if (indices_.data() == before) {
    views_[which] =
        topology_at(indices_.data() + first, topology.vertex_count, topology.edge_count, topology.face_count);
    const auto precedes = [&](std::uint64_t h, std::int32_t other) {
      return h < kept_[std::size_t(other)].hash;
    };
    by_hash_.insert(std::upper_bound(by_hash_.begin(), by_hash_.end(), hash, precedes), std::int32_t(which));
  } else {
    find_anew();
  }
  return std::int32_t(which);
}

void Topologies::release(std::int32_t which) {
  Kept& released = kept_[std::size_t(which)];
  if (--released.users > 0) return;
  const auto first = indices_.begin() + released.first;
  indices_.erase(first, first + released.length());
  for (Kept& kept : kept_) {
    if (kept.first > released.first) kept.first -= released.length();
  }
  released = {};
  while (!kept_.empty() && kept_.back().users == 0) kept_.pop_back();
  find_anew();
}

bool Topologies::lies_within(const Kept& kept) const {
  const std::int64_t all = std::int64_t(indices_.size());
  const auto is_count = [&](std::int32_t count, std::int32_t least) {
    return count >= least && count <= all;
  };
  const bool is_none = kept.vertices == 0 && kept.edges == 0 && kept.faces == 0;
  return (is_none || (is_count(kept.vertices, 4) && is_count(kept.edges, 6) && is_count(kept.faces, 4))) &&
         kept.first >= 0 && kept.first <= all - kept.length();
}

bool Topologies::is_sound(const Topology& t) const {
  const std::int32_t halves = 2 * t.edge_count;
  const bool has_loops = t.first_of_face[0] == 0 && t.first_of_face[t.face_count] == halves &&
                         std::is_sorted(t.first_of_face, t.first_of_face + t.face_count + 1);
  if (!has_loops) return false;
  if (t.vertex_count == 0) return t.first_of_vertex[0] == 0;
  Memory* const memory = indices_.get_allocator().resource();
  Polyhedron loops(memory);
  loops.vertices.resize(std::size_t(t.vertex_count));
  loops.first_of_face.assign(t.first_of_face, t.first_of_face + t.face_count + 1);
  loops.face_vertices.assign(t.face_vertex, t.face_vertex + halves);
  if (check_surface(loops).fault != Fault::none) return false;
  const TopologyArrays made_of_loops(loops, memory);
  return std::equal(t.first_of_face,
                    t.first_of_face + topology_length(t.vertex_count, t.edge_count, t.face_count),
                    made_of_loops.view().first_of_face);
}

bool Topologies::is_consistent() const {
  if (are_sound_) return true;
  if (views_.size() != kept_.size()) return false;
  Array<Range> ranges(kept_.get_allocator().resource());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (kept_[i].users < 0 || (kept_[i].users > 0 && !is_sound(views_[i]))) return false;
    if (kept_[i].users > 0) ranges.push_back({kept_[i].first, kept_[i].length()});
  }
  are_sound_ = fill_without_gap(ranges, indices_.size());
  return are_sound_;
}

void Topologies::hold_all_of(const Topologies& other) {
  indices_ = other.indices_;
  kept_ = other.kept_;
  for (Kept& kept : kept_) {
    kept.users = kept.users > 0;
    is_held_.push_back(kept.users > 0);
  }
  are_sound_ = other.are_sound_;
  by_hash_ = other.by_hash_;
  view_anew();
}

void Topologies::end_holding() {
  bool all_used = true;
  for (std::size_t i = 0; i < is_held_.size(); ++i) {
    kept_[i].users -= is_held_[i];
    all_used = all_used && (kept_[i].users > 0 || !is_held_[i]);
  }
  is_held_.clear();
  if (all_used) return;
  Array<std::int32_t> used(indices_.get_allocator());
  used.reserve(indices_.size());
  for (Kept& kept : kept_) {
    if (kept.users == 0) {
      kept = {};
      continue;
    }
    const auto first = indices_.begin() + kept.first;
    kept.first = std::int64_t(used.size());
    used.insert(used.end(), first, first + kept.length());
  }
  indices_.swap(used);
  while (!kept_.empty() && kept_.back().users == 0) kept_.pop_back();
  find_anew();
}

}  // namespace halfspace
