#include "neighbor/neighbor_search.h"

#include <set>

#include "catch.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using PairSet = std::set<std::pair<int, int>>;

PairSet by_all_pairs(const std::vector<Box<2>>& boxes) {
  PairSet pairs;
  for (int i = 0; i < int(boxes.size()); ++i) {
    for (int j = i + 1; j < int(boxes.size()); ++j) {
      if (boxes[std::size_t(i)].overlaps(boxes[std::size_t(j)])) pairs.insert({i, j});
    }
  }
  return pairs;
}

PairSet by_search(const std::vector<Box<2>>& boxes) {
  PairSet pairs;
  NeighborSearch<2> search(std::pmr::get_default_resource());
  search.search(
      std::span<const Box<2>>(boxes), [](std::size_t) { return true; },
      [&](const BlockPair& p) {
        CHECK(p.a < p.b);
        CHECK(pairs.insert({p.a, p.b}).second);  // each pair once
      });
  return pairs;
}

}  // namespace

TEST_CASE("no pair is lost at any ratio of sizes") {
  Random random(31);
  for (const double smallest : {1.0, 1e-2, 1e-6}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<Box<2>> boxes;
      for (int i = 0; i < 300; ++i) {
        const double size = std::pow(smallest, random.uniform(0, 1));
        const Vector<2> lower = {random.uniform(-5, 5), random.uniform(-5, 5)};
        const double slender = random.uniform(0, 1);
        boxes.push_back({lower, lower + size * Vector<2>(1, slender)});
      }
      CHECK(by_search(boxes) == by_all_pairs(boxes));
    }
  }
}

TEST_CASE("grains on a plate, and grains that only touch, are found") {
  std::vector<Box<2>> boxes = {{{-10, -1}, {10, 0}}};
  for (int i = 0; i < 1000; ++i) boxes.push_back({{-10 + 0.02 * i, 0}, {-10 + 0.02 * (i + 1), 0.01}});
  CHECK(by_search(boxes) == by_all_pairs(boxes));
}

TEST_CASE("far-off and huge coordinates lose no pair either") {
  std::vector<Box<2>> boxes;
  for (double away : {0.0, 1e20, -1e20, 1e60}) {
    boxes.push_back({{away, away}, {away + 1, away + 1}});
    boxes.push_back({{away, away}, {away + 1e-3, away + 1e-3}});
  }
  CHECK(by_search(boxes) == by_all_pairs(boxes));
}
