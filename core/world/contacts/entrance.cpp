#include "world/contacts/entrance.h"

#include <algorithm>
#include <utility>

#include "narrow_phase/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {
namespace {

/// Surfaces are flush when they differ by at most this fraction of the smaller radius: files round their
/// coordinates, and supports deflect.
constexpr double flush = 1e-3;

/// Minimum cosine of the angle between the lift and the normal of an entry face that it reveals.
constexpr double least_cosine = 0.5;

/// A contact is at a corner when it is nearer to an end of its face than this fraction of the smaller radius.
constexpr double corner = 1e-2;

/// Another face must leave this much less of an overlap, so that the answer does not swing.
constexpr double clearly_less = 0.5;

/// Nor may it leave a larger part of its own overlap, with this reserve.
constexpr double larger_part = 1.1;

/// A face carries where lifts leave at most this part of its overlap. Where supports deflect they leave more.
constexpr double most_left = 0.1, most_left_on_supports = 0.6;

/// A face has just been crossed when it is overlapped by less than this part of another.
constexpr double just_crossed = 0.1;

/// The gap along a face before and after a lift, negative in an overlap.
struct Lifted {
  double gap;
  double left;
};

/// Does another face take the place of the cached one? When two blocks meet, the cached one is what a lift
/// has shown, and the other one where they came in.
bool replaces(const Lifted& other, const Lifted& own, bool has_met) {
  const bool carries_on_supports = own.left > most_left_on_supports * own.gap;
  if (has_met) {
    if (carries_on_supports || other.left < -just_crossed * own.left) return false;
  } else {
    const bool is_crossed = other.gap > just_crossed * own.gap;
    if (own.left > most_left * own.gap || (carries_on_supports && is_crossed)) return false;
  }
  const double left = std::min(other.left, 0.0);
  return left > clearly_less * own.left && left * own.gap <= larger_part * own.left * other.gap;
}

template <int D, class Predicate>
bool all_points(const Contact<D>& contact, Predicate predicate) {
  return std::all_of(contact.points, contact.points + contact.point_count, predicate);
}

bool is_at_corner(const PlacedBlocks<2>& at, const Contact<2>& contact, double width) {
  const bool is_of_a = contact.pair.owner == 0;
  const Outline<2>& owner = is_of_a ? at.a : at.b;
  const Vector<2> place = is_of_a ? Vector<2>::Zero() : at.to_b;
  const auto is_near = [&](int vertex) {
    return all_points(contact,
                      [&](const Vector<2>& p) { return (p - place - owner.vertex(vertex)).norm() < width; });
  };
  return is_near(contact.pair.edge) || is_near(owner.next(contact.pair.edge));
}

/// In space the ends of a face are its edges. Crossing edges meet at no corner.
bool is_at_corner(const PlacedBlocks<3>& at, const Contact<3>& contact, double width) {
  if (contact.pair.kind == PotentialPair<3>::edge_edge) return false;
  const bool is_of_a = contact.pair.kind == PotentialPair<3>::face_vertex;
  const SeenOutline owner = is_of_a ? at.a : at.b;
  const Vector<3> place = is_of_a ? Vector<3>::Zero() : at.to_b;
  const int face = is_of_a ? contact.pair.a : contact.pair.b;
  const Topology& topology = *owner.topology;
  const auto is_near = [&](int edge) {
    const Vector<3> start = owner.vertex(topology.edge_start[edge]) + place;
    const Vector<3> across = cross_product(owner.normal(face), edge_vector(owner, edge)).normalized();
    return all_points(contact, [&](const Vector<3>& p) { return std::abs(across.dot(p - start)) < width; });
  };
  return std::any_of(topology.face_edge + topology.first_of_face[face],
                     topology.face_edge + topology.first_of_face[face + 1], is_near);
}

}  // namespace

/// Pairs that meet in this detection do not count, so the order of pairs does not matter.
template <int D>
bool Entrances<D>::does_touch(std::size_t k, std::span<const PairSums> found) const {
  if (!contacts_.was_in_contact(contacts_.neighbors().pairs()[k])) return false;
  if (found.empty()) return true;
  const std::size_t chunk = k / pairs_per_chunk;
  const auto met = contacts_.met_in(chunk, found[chunk]);
  return !std::binary_search(met.begin(), met.end(), k);
}

/// Lifts a block of a pair out of a third.
template <int D>
typename Entrances<D>::Lift Entrances<D>::lift(const Candidate<D>& pair, std::int32_t lifted,
                                               const Candidate<D>& known) const {
  Contact<D> contact;
  contacts_.describe(known, contact);
  // From the third block to the lifted one.
  const Vector<D> up = known.a == lifted ? Vector<D>(-contact.normal) : contact.normal;
  const double sign = pair.a == lifted ? -1 : 1;
  return {sign * up, std::max(-contact.gap, 0.0)};
}

/// The pair along the lift if it leaves the two blocks flush or apart, else the pair of the largest gap if
/// that separates them, else none.
template <int D>
typename Entrances<D>::Way Entrances<D>::way_along(const Candidate<D>& met, const PlacedBlocks<D>& at,
                                                   const Vector<D>& normal) const {
  const double entrance_cosine = normal_of(at.a, at.b, met.witness.pair).dot(normal);
  const auto is_another_way = [&](const PotentialPair<D>& pair) {
    const double cosine = normal_of(at.a, at.b, pair).dot(normal);
    return cosine >= least_cosine && cosine > entrance_cosine;
  };
  PotentialPair<D> pair = pair_along(at.a, at.b, at.to_b, normal);
  const double gap = refresh(at.a, at.b, at.to_b, pair);
  if (gap >= -flush * smaller_radius(met) && is_another_way(pair)) return {pair, gap};
  const Separation<D> apart = find_largest_separation(at.a, at.b, at.to_b);
  if (!(apart.gap > 0)) return {};
  pair = initial_pair(at.a, at.b, at.to_b, witness_of(apart));
  return is_another_way(pair) ? Way{pair, apart.gap} : Way{};
}

/// Was a face overlapped before the motion that has brought two blocks together? One that was not has just
/// been crossed, and covers nothing.
template <int D>
bool Entrances<D>::was_overlapped(const Candidate<D>& met, PotentialPair<D> face, double made) const {
  const Blocks<D>& blocks = model_.blocks;
  const PlacedBlocks<D> at = blocks.placed(met.a, met.b);
  const double gap = refresh(at.a, at.b, at.to_b, face);
  const Vector<D> velocity = blocks.velocity[std::size_t(met.b)] - blocks.velocity[std::size_t(met.a)];
  return gap - made * normal_of(at.a, at.b, face).dot(velocity) <= 0;
}

/// A long floor touches blocks that are far from the one that it meets. Of those that touch a fixed or
/// prescribed block, only neighbours of the met one count: shares know no others.
template <int D>
typename Entrances<D>::Way Entrances<D>::free_way(const Candidate<D>& met, std::span<const PairSums> found,
                                                  double made) const {
  const NeighborList<D>& neighbors = contacts_.neighbors();
  Way best;
  for (const std::int32_t block : {met.a, met.b}) {
    const std::int32_t other = met.a + met.b - block;
    const bool reaches_far = !model_.blocks.moves_freely(std::size_t(block));
    neighbors.for_each_pair_of(block, [&](std::size_t k) {
      const Candidate<D>& known = neighbors.pairs()[k];
      if (!does_touch(k, found)) return;
      if (reaches_far && !neighbors.pair_between(known.a + known.b - block, other)) return;
      const auto [normal, depth] = lift(met, block, known);
      PlacedBlocks<D> at = model_.blocks.placed(met.a, met.b);
      at.to_b += depth * normal;
      const Way way = way_along(met, at, normal);
      if (way.gap > best.gap && was_overlapped(met, way.pair, made)) best = way;
    });
  }
  return best;
}

/// Counts third blocks that touch both, and lifts both out of them: what presses on both alike tells nothing.
/// Laws by overlap have no entry face. A face that is overlapped deeper than flush, and deeper than the
/// cached one, is none either: its spring would make energy. `found` is empty for a cached contact.
template <int D>
std::optional<PotentialPair<D>> Entrances<D>::better_face(std::size_t k,
                                                          std::span<const PairSums> found) const {
  NeighborList<D>& neighbors = contacts_.neighbors();
  const Candidate<D>& pair = neighbors.pairs()[k];
  if (pair.bonded || model_.law_of(pair).is_potential()) return {};
  Contact<D> contact;
  contacts_.describe(pair, contact);
  const PlacedBlocks<D> placed = model_.blocks.placed(pair.a, pair.b);
  if (!is_at_corner(placed, contact, corner * smaller_radius(pair))) return {};

  neighbors.index_pairs();
  const auto moves = [&](std::int32_t block) { return model_.blocks.moves_freely(std::size_t(block)); };
  double left = contact.gap;  // of the overlap, after the best lift along its own face
  Way best;
  for (const std::int32_t block : {pair.a, pair.b}) {
    const std::int32_t other = pair.a + pair.b - block;
    neighbors.for_each_pair_of(block, [&](std::size_t known_k) {
      const Candidate<D>& known = neighbors.pairs()[known_k];
      const std::int32_t third = known.a + known.b - block;
      if (third == other || !does_touch(known_k, found)) return;
      // No pair of the list is between blocks that do not move; they count as touching.
      const std::optional<std::size_t> beside = neighbors.pair_between(third, other);
      const bool do_touch = beside ? does_touch(*beside, found) : !moves(third) && !moves(other);
      if (!do_touch) return;
      const Lift of_block = lift(pair, block, known);
      PlacedBlocks<D> at = placed;
      at.to_b += of_block.depth * of_block.normal;
      if (beside) {
        const Lift of_other = lift(pair, other, neighbors.pairs()[*beside]);
        at.to_b += of_other.depth * of_other.normal;
      }
      PotentialPair<D> own = pair.witness.pair;
      left = std::max(left, refresh(at.a, at.b, at.to_b, own));
      const Way way = way_along(pair, at, of_block.normal);
      if (way.gap > best.gap) best = way;
    });
  }
  if (!(best.gap > -HUGE_VAL)) return {};
  const double before = refresh(placed.a, placed.b, placed.to_b, best.pair);
  if (!replaces({before, best.gap}, {contact.gap, left}, !found.empty())) return {};
  if (before < std::min(contact.gap, -flush * smaller_radius(pair))) return {};
  return best.pair;
}

template <int D>
bool Entrances<D>::find(std::size_t k, std::span<const PairSums> found, double made) {
  contacts_.neighbors().index_pairs();
  Candidate<D>& met = contacts_.neighbors().pairs()[k];
  if (met.bonded) return false;
  const Way way = free_way(met, found, made);
  if (!(way.gap > -HUGE_VAL)) return false;
  const PotentialPair<D> entry = std::exchange(met.witness.pair, way.pair);
  if (!better_face(k, found)) return true;
  met.witness.pair = entry;
  return false;
}

template <int D>
void Entrances<D>::ask_again(std::uint32_t k) {
  if (const auto face = better_face(k, {})) answers_.push_back({k, *face});
}

template <int D>
void Entrances<D>::describe(std::size_t k, Contact<D>& contact) {
  Candidate<D>& met = contacts_.neighbors().pairs()[k];
  const PlacedBlocks<D> at = model_.blocks.placed(met.a, met.b);
  describe_contact<D>(at.a, at.b, at.to_b, met.witness, model_.settings.detect, contact);
}

template class Entrances<2>;
template class Entrances<3>;

}  // namespace halfspace
