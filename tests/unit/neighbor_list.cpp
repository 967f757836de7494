#include "world/contacts/neighbor_list.h"

#include <cmath>
#include <set>

#include "catch.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using PairSet = std::set<std::pair<std::int32_t, std::int32_t>>;

template <int D>
PairSet listed(const NeighborList<D>& list) {
  PairSet pairs;
  for (const Candidate<D>& pair : list.pairs()) {
    CHECK(pair.a < pair.b);
    CHECK((pairs.empty() || *pairs.rbegin() < std::pair(pair.a, pair.b)));  // in order
    pairs.insert({pair.a, pair.b});
  }
  return pairs;
}

/// Boxes along the axes, every third of them fixed.
template <int D>
struct Heap : WorldParts<D> {
  std::vector<Vector<D>> sides;

  Heap(Random& random, int count, double region) : WorldParts<D>(ContactLaw()) {
    for (int i = 0; i < count; ++i) {
      Vector<D> size, place;
      for (int k = 0; k < D; ++k) {
        size[k] = random.uniform(0.1, 1);
        place[k] = random.uniform(0, region);
      }
      sides.push_back(size);
      this->add(cuboid<D>(size), i % 3 == 0 ? BlockKind::fixed : BlockKind::rigid, place);
    }
  }

  /// The way between two boxes along each axis, 0 where they overlap.
  Vector<D> apart(std::size_t a, std::size_t b) const {
    const Vector<D> way = (this->blocks.position[b] - this->blocks.position[a]).cwiseAbs();
    return (way - 0.5 * (sides[a] + sides[b])).cwiseMax(0);
  }
};

}  // namespace

/// Between corners the list may look along the axes only: it may hold more pairs than are that near.
TEMPLATE_TEST_CASE_SIG(
    "the list has all pairs within their skins, and none that are farther apart on any axis", "",
    ((int D), D), 2, 3) {
  Random random(7);
  std::size_t near = 0;
  for (int round = 0; round < 20; ++round) {
    Heap<D> heap(random, 60, D == 2 ? 8 : 3);
    heap.list_neighbors();
    const PairSet pairs = listed(heap.neighbors);
    const auto& skin = std::get<0>(heap.neighbors.skins());
    CHECK_FALSE(heap.neighbors.needs_rebuild());
    for (std::int32_t a = 0; a < 60; ++a) {
      for (std::int32_t b = a + 1; b < 60; ++b) {
        const std::size_t i = std::size_t(a), j = std::size_t(b);
        const double reach = skin[i] + skin[j];
        const Vector<D> apart = heap.apart(i, j);
        const bool may_move = a % 3 != 0 || b % 3 != 0;
        if (may_move && apart.norm() <= reach * (1 - 1e-12)) {
          CHECK(pairs.count({a, b}) == 1);
          ++near;
        }
        if (!may_move || apart.maxCoeff() > reach * (1 + 1e-12)) CHECK(pairs.count({a, b}) == 0);
      }
    }
  }
  CHECK(near > 500);
}

TEMPLATE_TEST_CASE_SIG("a skin is a share of a block's size, and a fixed block has none", "", ((int D), D), 2,
                       3) {
  WorldSettings<D> settings;
  settings.skin = 0.25;
  WorldParts<D> parts(ContactLaw(), settings);
  parts.add(cube<D>(), BlockKind::fixed, at<D>(0, 0));
  parts.add(cube<D>(), BlockKind::rigid, at<D>(5, 0));
  parts.list_neighbors();
  const auto& skin = std::get<0>(parts.neighbors.skins());
  CHECK(skin[0] == 0);
  CHECK(skin[1] == Approx(0.25 * std::sqrt(D)));
}

TEMPLATE_TEST_CASE_SIG("the list is used up when a block is to move, or turn, by more than its skin", "",
                       ((int D), D), 2, 3) {
  WorldParts<D> parts{ContactLaw()};
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0));
  parts.list_neighbors();
  NeighborList<D>& list = parts.neighbors;
  const double skin = std::get<0>(list.skins())[0];
  list.end_announcements(false);
  CHECK_FALSE(list.announce(parts.blocks, 0, 0.99 * skin));
  CHECK(list.announced_motion(0) == 0.99 * skin);
  CHECK(list.announce(parts.blocks, 0, 1.01 * skin));
  parts.blocks.place(0, at<D>(0.6 * skin, 0), {});
  list.note_placement(parts.blocks, 0);
  CHECK_FALSE(list.needs_rebuild());
  CHECK(list.announce(parts.blocks, 0, 0.5 * skin));  // both ways together

  parts.list_neighbors();
  Angular<D> turn = Angular<D>::Zero();
  turn[0] = 2 * skin / parts.blocks.radius[0];
  parts.blocks.place(0, at<D>(0.6 * skin, 0), Rotation<D>().turned_by(turn));
  list.note_placement(parts.blocks, 0);
  CHECK(list.needs_rebuild());
}

TEMPLATE_TEST_CASE_SIG("a pair that stays keeps what it remembers, and a bonded one stays", "", ((int D), D),
                       2, 3) {
  WorldParts<D> parts{ContactLaw()};
  for (const double x : {0.0, 1.0, 2.0, 3.0}) parts.add(cube<D>(), BlockKind::rigid, at<D>(x, 0));
  parts.list_neighbors();
  REQUIRE(listed(parts.neighbors) == PairSet{{0, 1}, {1, 2}, {2, 3}});
  parts.neighbors.pairs()[1].witness.state = PairCache<D>::overlapping;
  parts.neighbors.pairs()[2].bonded = true;
  parts.blocks.place(0, at<D>(-9, 0), {});
  parts.blocks.place(3, at<D>(12, 0), {});
  parts.list_neighbors();
  REQUIRE(listed(parts.neighbors) == PairSet{{1, 2}, {2, 3}});
  CHECK(parts.neighbors.pairs()[0].witness.state == PairCache<D>::overlapping);
  CHECK(parts.neighbors.pairs()[1].witness.state == PairCache<D>::unknown);
  CHECK(parts.neighbors.builds() == 2);
  parts.neighbors.forget(2);
  CHECK(parts.neighbors.pairs().empty());
}

TEST_CASE("a block is calm in half a quarter of what is thinner, itself or a neighbour") {
  WorldParts<2> parts{ContactLaw()};
  parts.add(cuboid<2>({4, 0.5}), BlockKind::rigid, {0, 0});
  parts.add(cuboid<2>({4, 1}), BlockKind::fixed, {0, 0.75});
  parts.add(cuboid<2>({4, 2}), BlockKind::rigid, {0, 2.25});
  parts.add(cuboid<2>({4, 2}), BlockKind::rigid, {0, 50});
  parts.list_neighbors();
  CHECK(parts.neighbors.safe_displacement(0) == Approx(0.5 / 8));
  CHECK(parts.neighbors.safe_displacement(2) == Approx(1.0 / 8));
  CHECK(parts.neighbors.safe_displacement(3) == HUGE_VAL);
  CHECK(parts.neighbors.min_safe_displacement() == Approx(0.5 / 8));
}
