#include <Eigen/LU>
#include <algorithm>

#include "block/bond/common_face.h"
#include "world/world.h"

// External edits: bonds.

namespace halfspace {
namespace {

/// Transforms a point or a normal into the frame of a block's shape.
template <int D>
Tensor<D> to_frame(const Blocks<D>& blocks, std::int32_t block) {
  return blocks.gradient(std::size_t(block)).inverse();
}
template <int D>
Vector<D> normal_in_frame(const Blocks<D>& blocks, std::int32_t block, const Vector<D>& normal) {
  return (blocks.gradient(std::size_t(block)).transpose() * normal).normalized();
}

/// Bonds two blocks along their current common face. False if there is none, or if they are joined already.
template <int D>
bool bond_pair(Blocks<D>& blocks, std::int32_t a, std::int32_t b, std::int32_t law, Memory* memory) {
  if (a > b) std::swap(a, b);
  if (blocks.are_joined(std::size_t(a), std::size_t(b))) return false;
  const std::optional<CommonFace<D>> face = common_face(blocks, a, b, memory);
  if (!face) return false;
  const Tensor<D> to_a = to_frame(blocks, a), to_b = to_frame(blocks, b);
  const Vector<D> way = blocks.position[std::size_t(b)] - blocks.position[std::size_t(a)];
  Array<BondPoint<D>> points(memory);
  double area = 0;
  for (const FacePoint<D>& place : face->points) {
    BondPoint<D> point;
    point.on_a = to_a * place.place;
    point.on_b = to_b * (place.place - way);
    point.area = place.area;
    area += place.area;
    points.push_back(point);
  }
  Bond<D> bond;
  bond.a = a;
  bond.b = b;
  bond.law = law;
  bond.normal_a = normal_in_frame(blocks, a, face->normal);
  bond.normal_b = normal_in_frame(blocks, b, face->normal);
  bond.extent = D == 2 ? area : std::sqrt(area);
  blocks.bonds().add(bond, points);
  return true;
}

/// Adds the law and calls make(number), which makes bonds of this law and returns their number. Removes the
/// law if there are none, or if memory runs out.
template <int D, class Make>
std::int64_t make_bonds_of(State<D>& state, const BondLaw& law, Make make) {
  Bonds<D>& bonds = state.model.blocks.bonds();
  const std::int32_t number = bonds.add_law(law.weaker_by(state.strength_factor));
  std::int64_t count = 0;
  try {
    count = make(number);
  } catch (...) {
    bonds.take_back_law();
    throw;
  }
  if (count == 0) {
    bonds.take_back_law();
    return 0;
  }
  bonds.index();
  bonds.rings().invalidate();
  // Bonds replace the bonds of contact laws.
  for (Candidate<D>& pair : state.contacts.neighbors().pairs()) {
    if (pair.bonded && bonds.keeps(pair.a, pair.b)) pair.bonded = 0;
  }
  state.change_pairs();  // rings of bonds exclude pairs
  return count;
}

}  // namespace

template <int D>
bool World<D>::bond_pair(std::int32_t a, std::int32_t b, const BondLaw& law) {
  const auto make = [&](std::int32_t number) {
    return std::int64_t(halfspace::bond_pair(model_.blocks, a, b, number, state_.memory()));
  };
  return make_bonds_of(state_, law, make) > 0;
}

/// A neighbour list contains all pairs that touch: the one in use, or else one for this call alone, so that
/// nothing has changed when memory runs out.
template <int D>
std::int64_t World<D>::bond_materials(std::int32_t material_a, std::int32_t material_b, const BondLaw& law) {
  NeighborList<D> own(state_.threads, state_.memory());
  const bool is_list_in_use = !state_.contacts.neighbors().needs_rebuild();
  if (!is_list_in_use) {
    own.search_again(model_.blocks, {model_.settings.skin}, false);
    own.renew(model_.blocks, false);
  }
  const Array<Candidate<D>>& pairs = is_list_in_use ? state_.contacts.neighbors().pairs() : own.pairs();
  const auto are_wanted = [&](const Candidate<D>& pair) {
    const std::int32_t of_a = model_.blocks.material[std::size_t(pair.a)];
    const std::int32_t of_b = model_.blocks.material[std::size_t(pair.b)];
    return (of_a == material_a && of_b == material_b) || (of_a == material_b && of_b == material_a);
  };
  return make_bonds_of(state_, law, [&](std::int32_t number) {
    std::int64_t count = 0;
    for (const Candidate<D>& pair : pairs) {
      if (!are_wanted(pair)) continue;
      count += halfspace::bond_pair(model_.blocks, pair.a, pair.b, number, state_.memory());
    }
    return count;
  });
}

template <int D>
void World<D>::hold_bonds(bool are_held) {
  state_.sleep.wake_all(state_.clock.time());
  model_.blocks.bonds().hold(are_held);
}

#define HALFSPACE_MEMBERS(D)                                                                  \
  template bool World<D>::bond_pair(std::int32_t, std::int32_t, const BondLaw&);              \
  template std::int64_t World<D>::bond_materials(std::int32_t, std::int32_t, const BondLaw&); \
  template void World<D>::hold_bonds(bool);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
