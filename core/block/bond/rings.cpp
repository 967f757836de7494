#include "block/bond/rings.h"

#include <algorithm>

#include "block/blocks.h"
#include "block/bond/common_face.h"
#include "block/bond/pair_key.h"
#include "geometry/numbers.h"
#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// A direction to which few edges and faces of regular bodies are normal.
template <int D>
Vector<D> odd_direction() {
  constexpr double odd[] = {0.8017, 0.5345, 0.2673};
  return Eigen::Map<const Vector<D>>(odd).normalized();
}

}  // namespace

/// A point of a bond, and the blocks that it joins.
template <int D>
struct BondRings<D>::End {
  Vector<D> place;
  double along = 0;
  double reach = 0;
  std::int64_t point = 0;
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t ring = 0;
};

template <int D>
class BondRings<D>::Finder {
 public:
  Finder(const Blocks<D>& blocks, Memory* memory)
      : blocks_(blocks), memory_(memory), ends_(memory), of_node_(memory), members(memory), links(memory) {
    collect_ends();
    number_rings();
    collect_cells();
    for (std::size_t first = 0; first < ends_.size();) {
      std::size_t past = first;
      while (past < ends_.size() && ends_[past].ring == ends_[first].ring) ++past;
      if (past - first > 1 || is_at_mesh(ends_[first])) add_ring({ends_.data() + first, past - first});
      first = past;
    }
    sort_members();
  }

  /// Pairs of blocks in one ring that have a common face, bonded or not: when it opens, they may touch again.
  void add_faced(Array<std::uint64_t>& faced) const {
    Array<Member> by_ring(members, memory_);
    std::sort(by_ring.begin(), by_ring.end(), [](const Member& one, const Member& other) {
      return std::tie(one.ring, one.block) < std::tie(other.ring, other.block);
    });
    for (std::size_t i = 0; i < by_ring.size(); ++i) {
      for (std::size_t k = i + 1; k < by_ring.size() && by_ring[k].ring == by_ring[i].ring; ++k) {
        if (have_face(by_ring[i].block, by_ring[k].block))
          faced.push_back(pair_key(by_ring[i].block, by_ring[k].block));
      }
    }
    std::sort(faced.begin(), faced.end());
    faced.erase(std::unique(faced.begin(), faced.end()), faced.end());
  }

 private:
  bool is_at_mesh(const End& end) const {
    return blocks_.is_of_mesh(std::size_t(end.a)) || blocks_.is_of_mesh(std::size_t(end.b));
  }

  bool have_face(std::int32_t a, std::int32_t b) const {
    return blocks_.bonds().keeps(a, b) || common_face(blocks_, a, b, memory_);
  }

  void collect_ends() {
    const Vector<D> direction = odd_direction<D>();
    for (const Bond<D>& bond : blocks_.bonds().all()) {
      if (!bond.is_joint) continue;
      const std::size_t a = std::size_t(bond.a);
      std::int64_t number = bond.first_point;
      for (const BondPoint<D>& point : blocks_.bonds().points_of(bond)) {
        End end;
        end.place = blocks_.position[a] + blocks_.gradient(a) * point.on_a;
        end.along = direction.dot(end.place);
        end.reach = corner_reach * std::min(blocks_.radius[a], blocks_.radius[std::size_t(bond.b)]);
        end.point = number++;
        end.a = bond.a;
        end.b = bond.b;
        ends_.push_back(end);
      }
    }
  }

  /// Ends that coincide get one number: that of the first of them along the direction.
  void number_rings() {
    std::sort(ends_.begin(), ends_.end(), [](const End& one, const End& other) {
      return std::tie(one.along, one.point) < std::tie(other.along, other.point);
    });
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      ends_[i].ring = std::int32_t(i);
      for (std::size_t k = i; k-- > 0 && ends_[i].along - ends_[k].along <= ends_[i].reach;) {
        if ((ends_[i].place - ends_[k].place).norm() <= ends_[i].reach) ends_[i].ring = ends_[k].ring;
      }
    }
    std::stable_sort(ends_.begin(), ends_.end(),
                     [](const End& one, const End& other) { return one.ring < other.ring; });
  }

  /// The blocks at the surface of meshes, by node.
  void collect_cells() {
    for (const SurfaceCell<D>& cell : blocks_.meshes().surface()) {
      for (const std::int32_t node : cell.node) of_node_.push_back({node, cell.block});
    }
    std::sort(of_node_.begin(), of_node_.end(), [](const AtNode& one, const AtNode& other) {
      return std::tie(one.node, one.block) < std::tie(other.node, other.block);
    });
  }

  void add_ring(std::span<const End> ends) {
    first_of_ring_ = members.size();
    for (const End& end : ends) links.push_back({end.point, member(end, end.a), member(end, end.b)});
  }

  /// Returns the index of a block's member of the present ring; adds it if needed.
  std::int32_t member(const End& end, std::int32_t block) {
    for (std::size_t i = first_of_ring_; i < members.size(); ++i) {
      if (members[i].block == block) return std::int32_t(i);
    }
    const std::int32_t number = std::int32_t(members.size());
    members.push_back({block, end.ring, 0, 0});
    if (blocks_.is_of_mesh(std::size_t(block))) add_neighbors_in_mesh(end, block, number);
    return number;
  }

  void add_neighbors_in_mesh(const End& end, std::int32_t block, std::int32_t number) {
    const Meshes<D>& meshes = blocks_.meshes();
    const SurfaceCell<D>& cell = meshes.surface_of_block(std::size_t(block));
    const Vector<D> place = end.place - meshes.body(cell.body).origin;
    for (const std::int32_t node : cell.node) {
      if (!((meshes.place[std::size_t(node)] - place).norm() <= end.reach)) continue;
      auto at = std::lower_bound(of_node_.begin(), of_node_.end(), node,
                                 [](const AtNode& one, std::int32_t wanted) { return one.node < wanted; });
      for (; at != of_node_.end() && at->node == node; ++at) {
        if (at->block != block) links.push_back({-1, number, member(end, at->block)});
      }
    }
  }

  void sort_members() {
    Array<std::int32_t> order(members.size(), memory_), place(members.size(), memory_);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::int32_t(i);
    std::sort(order.begin(), order.end(), [&](std::int32_t one, std::int32_t other) {
      return members[std::size_t(one)].key() < members[std::size_t(other)].key();
    });
    Array<Member> sorted(memory_);
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[std::size_t(order[i])] = std::int32_t(i);
      sorted.push_back(members[std::size_t(order[i])]);
    }
    for (Link& link : links) {
      link.one = place[std::size_t(link.one)];
      link.other = place[std::size_t(link.other)];
    }
    members.swap(sorted);
  }

  struct AtNode {
    std::int32_t node;
    std::int32_t block;
  };

  const Blocks<D>& blocks_;
  Memory* memory_;
  Array<End> ends_;
  Array<AtNode> of_node_;
  std::size_t first_of_ring_ = 0;

 public:
  Array<Member> members;
  Array<Link> links;
};

template <int D>
void BondRings<D>::find(const Blocks<D>& blocks) {
  Memory* memory = members_.get_allocator().resource();
  Finder found(blocks, memory);
  Array<std::uint64_t> faced(faced_, memory);
  found.add_faced(faced);
  members_.swap(found.members);
  links_.swap(found.links);
  faced_.swap(faced);
  regroup(blocks.bonds().points());
  is_current_ = 1;
}

/// Each member takes the smallest group of its links, until none changes.
template <int D>
void BondRings<D>::regroup(std::span<const BondPoint<D>> points) {
  for (std::size_t i = 0; i < members_.size(); ++i) members_[i].group = std::int32_t(i);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const Link& link : links_) {
      if (link.point >= 0 && points[std::size_t(link.point)].is_broken()) continue;
      std::int32_t& one = members_[std::size_t(link.one)].group;
      std::int32_t& other = members_[std::size_t(link.other)].group;
      goes_on = goes_on || one != other;
      one = other = std::min(one, other);
    }
  }
}

template <int D>
bool BondRings<D>::look(std::span<const BondPoint<D>> points) {
  for (Member& member : members_) member.former_group = member.group;
  regroup(points);
  return !halfspace::all(members_, [](const Member& member) { return member.group == member.former_group; });
}

template <int D>
bool BondRings<D>::hold(std::int32_t a, std::int32_t b) const {
  const auto rings_of = [&](std::int32_t block) {
    return std::lower_bound(members_.begin(), members_.end(), block,
                            [](const Member& one, std::int32_t wanted) { return one.block < wanted; });
  };
  auto of_a = rings_of(a), of_b = rings_of(b);
  while (of_a != members_.end() && of_b != members_.end() && of_a->block == a && of_b->block == b) {
    if (of_a->ring == of_b->ring && of_a->group == of_b->group)
      return !std::binary_search(faced_.begin(), faced_.end(), pair_key(a, b));
    of_a->ring < of_b->ring ? ++of_a : ++of_b;
  }
  return false;
}

template <int D>
bool BondRings<D>::is_consistent(std::size_t slots, std::size_t points) const {
  const auto is_member = [&](std::int32_t i) { return i >= 0 && std::size_t(i) < members_.size(); };
  return halfspace::all(
             members_,
             [&](const Member& member) { return member.block >= 0 && std::size_t(member.block) < slots; }) &&
         halfspace::all(links_,
                        [&](const Link& link) {
                          return link.point >= -1 && link.point < std::int64_t(points) &&
                                 is_member(link.one) && is_member(link.other);
                        }) &&
         std::is_sorted(members_.begin(), members_.end(),
                        [](const Member& one, const Member& other) { return one.key() < other.key(); }) &&
         std::is_sorted(faced_.begin(), faced_.end());
}

template class BondRings<2>;
template class BondRings<3>;

}  // namespace halfspace
