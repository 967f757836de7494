#include "benchmarks/halfspace_block.h"
#include "benchmarks/peer_of.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/space/separation.h"

namespace halfspace_benchmark {
namespace {

using halfspace::Rotation;
using halfspace::Vector;
using Block = HalfspaceBlock;

/// Two blocks, each in its own frame, seen from that of a.
struct Seen {
  const halfspace::Outline<3>& a;
  const halfspace::Outline<3>& b;
  Rotation<3> b_in_a;
  Vector<3> to_b;

  Seen(const Block& block_a, const hs_pose& at_a, const Block& block_b, const hs_pose& at_b)
      : a(block_a.shape.outline()), b(block_b.shape.outline()) {
    const Rotation<3> into_a = Rotation<3>::from_quaternion(at_a.rotation).inverse();
    b_in_a = into_a * Rotation<3>::from_quaternion(at_b.rotation);
    const double *from = at_a.position, *to = at_b.position;
    const Vector<3> apart(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    to_b = into_a * apart + (b_in_a * block_b.centroid - block_a.centroid);
  }
};

/// The verdict, and the least depth of blocks that overlap.
Answer search(const Seen& seen) {
  const halfspace::Separation<3> found = halfspace::find_separation(seen.a, seen.b, seen.to_b, seen.b_in_a);
  return {found.gap <= 0, -found.gap, false};
}

Answer described(const Seen& seen, const halfspace::SeenOutline& b, const halfspace::Separation<3>& found) {
  if (found.gap > 0) return {false, -found.gap, false};
  halfspace::PotentialPair<3> pair = found.pair;
  halfspace::Contact<3> contact;
  describe_contact(seen.a, b, seen.to_b, pair, {}, contact);
  return {true, -contact.gap, false};
}

/// The contact as well, with its type and region: what the others' answers hold of it is a point. Blocks of
/// few features are turned before the search, which would do it anyway.
Answer search_and_describe(const Seen& seen) {
  if (by_all_combinations(seen.a, seen.b)) {
    const halfspace::TurnedPolyhedron b(seen.b, seen.b_in_a);
    return described(seen, b.outline(), find_separation_by_all(seen.a, b.outline(), seen.to_b));
  }
  const halfspace::Separation<3> found = find_separation(seen.a, seen.b, seen.to_b, seen.b_in_a);
  return described(seen, {seen.b, seen.b_in_a}, found);
}

/// The core itself, without a memory.
template <Answer answer_of(const Seen&)>
struct Halfspace {
  struct Pair {
    const Block* a;
    const Block* b;
    hs_pose at_a;
    hs_pose at_b;
  };

  explicit Halfspace(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) blocks.push_back(std::make_unique<Block>(p));
    for (const PolyhedraAt& pair : set.pairs)
      pairs.push_back(
          {blocks[std::size_t(pair.a)].get(), blocks[std::size_t(pair.b)].get(), pair.at_a, pair.at_b});
  }

  Answer answer(const Pair& pair) const { return answer_of(Seen(*pair.a, pair.at_a, *pair.b, pair.at_b)); }

  std::vector<Pair> pairs;
  std::vector<std::unique_ptr<Block>> blocks;
};

}  // namespace

std::unique_ptr<Peer> make_halfspace(const PairSet3& set) {
  return std::make_unique<PeerOf<Halfspace<search>>>(set);
}
std::unique_ptr<Peer> make_halfspace_contact(const PairSet3& set) {
  return std::make_unique<PeerOf<Halfspace<search_and_describe>>>(set);
}

}  // namespace halfspace_benchmark
