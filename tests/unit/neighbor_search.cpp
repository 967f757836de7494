#include <set>

#include "broad_phase/grid.h"
#include "catch.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using PairSet = std::set<std::pair<int, int>>;

template <int D>
PairSet by_all_pairs(const std::vector<Box<D>>& boxes) {
  PairSet pairs;
  for (int i = 0; i < int(boxes.size()); ++i) {
    for (int j = i + 1; j < int(boxes.size()); ++j) {
      if (boxes[std::size_t(i)].overlaps(boxes[std::size_t(j)])) pairs.insert({i, j});
    }
  }
  return pairs;
}

template <int D>
PairSet by_search(const std::vector<Box<D>>& boxes) {
  PairSet pairs;
  Grid<D> search(std::pmr::get_default_resource());
  search.search(
      std::span<const Box<D>>(boxes), [](std::size_t) { return true; },
      [&](const BlockPair& p) {
        CHECK(p.a < p.b);
        CHECK(pairs.insert({p.a, p.b}).second);  // each pair once
      });
  return pairs;
}

/// Of all sizes from 1 down to `smallest`, and slender in all directions but one.
template <int D>
std::vector<Box<D>> random_boxes(Random& random, int count, double smallest, double region) {
  std::vector<Box<D>> boxes;
  for (int i = 0; i < count; ++i) {
    Vector<D> lower, size;
    for (int k = 0; k < D; ++k) {
      lower[k] = random.uniform(-region, region);
      size[k] = random.uniform(0, 1);
    }
    size[random.integer(0, D - 1)] = 1;
    boxes.push_back({lower, lower + std::pow(smallest, random.uniform(0, 1)) * size});
  }
  return boxes;
}

}  // namespace

TEST_CASE("no pair is lost at any ratio of sizes") {
  Random random(31);
  std::size_t pairs_in_plane = 0, pairs_in_space = 0;
  for (const double smallest : {1.0, 1e-2, 1e-6}) {
    for (int round = 0; round < 20; ++round) {
      const std::vector<Box<2>> plane = random_boxes<2>(random, 300, smallest, 5);
      const std::vector<Box<3>> space = random_boxes<3>(random, 300, smallest, 2);
      CHECK(by_search(plane) == by_all_pairs(plane));
      CHECK(by_search(space) == by_all_pairs(space));
      pairs_in_plane += by_all_pairs(plane).size();
      pairs_in_space += by_all_pairs(space).size();
    }
  }
  CHECK(pairs_in_plane > 1000);
  CHECK(pairs_in_space > 1000);
}

TEST_CASE("grains on a plate, and grains that only touch, are found") {
  std::vector<Box<2>> boxes = {{{-10, -1}, {10, 0}}};
  for (int i = 0; i < 1000; ++i) boxes.push_back({{-10 + 0.02 * i, 0}, {-10 + 0.02 * (i + 1), 0.01}});
  CHECK(by_search(boxes) == by_all_pairs(boxes));
}

TEST_CASE("in space, grains on a plate, and grains that only touch, are found") {
  std::vector<Box<3>> boxes = {{{-1, -1, -1}, {1, 1, 0}}};
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      boxes.push_back({{-1 + 0.1 * i, -1 + 0.1 * j, 0}, {-1 + 0.1 * (i + 1), -1 + 0.1 * (j + 1), 0.01}});
  CHECK(by_search(boxes) == by_all_pairs(boxes));
}

TEST_CASE("far-off and huge coordinates lose no pair either") {
  std::vector<Box<2>> plane;
  std::vector<Box<3>> space;
  for (const double away : {0.0, 1e20, -1e20, 1e60}) {
    for (const double size : {1.0, 1e-3}) {
      plane.push_back({{away, away}, {away + size, away + size}});
      space.push_back({{away, away, away}, {away + size, away + size, away + size}});
    }
  }
  CHECK(by_search(plane) == by_all_pairs(plane));
  CHECK(by_search(space) == by_all_pairs(space));
}
