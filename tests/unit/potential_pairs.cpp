#include "narrow_phase/plane/potential_pairs.h"

#include <set>
#include <tuple>

#include "catch.h"
#include "narrow_phase/pair.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using PairSet = std::set<std::tuple<int, int, int>>;

/// The definition, Wang et al. 2021, eq. 9, for all vertices and edges.
PairSet pairs_by_definition(const Outline<2>& a, const Outline<2>& b) {
  PairSet pairs;
  for (int owner = 0; owner < 2; ++owner) {
    const Outline<2>& with_edge = owner == 0 ? a : b;
    const Outline<2>& with_vertex = owner == 0 ? b : a;
    for (int e = 0; e < with_edge.count; ++e) {
      const Vector<2> inner = -with_edge.normal(e);
      for (int v = 0; v < with_vertex.count; ++v) {
        const Vector<2> here = with_vertex.vertex(v);
        const bool deepest = (with_vertex.vertex(with_vertex.previous(v)) - here).dot(inner) <= 0 &&
                             (with_vertex.vertex(with_vertex.next(v)) - here).dot(inner) <= 0;
        if (deepest) pairs.insert({owner, e, v});
      }
    }
  }
  return pairs;
}

PairSet pairs_by_merge(const Outline<2>& a, const Outline<2>& b) {
  PairSet pairs;
  for_each_potential_pair(a, b, [&](const PotentialPair<2>& p) {
    pairs.insert({p.owner, p.edge, p.vertex});
    return true;
  });
  return pairs;
}

double largest_gap_by_definition(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b) {
  double largest = -HUGE_VAL;
  for (const auto& [owner, edge, vertex] : pairs_by_definition(a, b)) {
    largest = std::max(largest,
                       owner == 0 ? edge_gap(a, edge, b, vertex, to_b) : edge_gap(b, edge, a, vertex, -to_b));
  }
  return largest;
}

}  // namespace

TEST_CASE("the merge of sorted normals visits exactly the potential pairs of the definition") {
  Random random(11);
  for (int round = 0; round < 300; ++round) {
    const Shape<2> a = shape_of(random_polygon(random, 25, 1));
    const Shape<2> b = shape_of(random_polygon(random, 25, random.uniform(0.01, 100)));
    CHECK(pairs_by_merge(a.outline(), b.outline()) == pairs_by_definition(a.outline(), b.outline()));
  }
}

TEST_CASE("neighbouring pairs go once round the Minkowski difference, either way") {
  Random random(12);
  for (int round = 0; round < 100; ++round) {
    const Shape<2> a = shape_of(random_polygon(random, 12, 1));
    const Shape<2> b = shape_of(random_polygon(random, 12, 2));
    const PairSet all = pairs_by_merge(a.outline(), b.outline());
    const auto [owner, edge, vertex] = *all.begin();
    const PotentialPair<2> start{owner, edge, vertex};
    PairSet forth, back;
    PotentialPair<2> p = start, q = start;
    for (std::size_t i = 0; i < all.size(); ++i) {
      p = next_pair(a.outline(), b.outline(), p);
      q = previous_pair(a.outline(), b.outline(), q);
      forth.insert({p.owner, p.edge, p.vertex});
      back.insert({q.owner, q.edge, q.vertex});
    }
    CHECK(p == start);
    CHECK(q == start);
    CHECK(forth == all);
    CHECK(back == all);
  }
}

TEST_CASE("separation by all combinations and by the merge both find the largest gap") {
  Random random(13);
  // Triangles and few vertices take the combinations, many the merge; the answer is that of the definition.
  for (const int most : {3, 8, 200}) {
    const auto draw = [&] {
      Points points = random_polygon(random, most, 1);
      if (most == 3) points.resize(3);
      return points;
    };
    for (int round = 0; round < 200; ++round) {
      const Shape<2> a = shape_of(draw());
      const Shape<2> b = shape_of(draw());
      const Vector<2> to_b = {random.uniform(-2, 2), random.uniform(-2, 2)};
      const Separation<2> found = find_separation(a.outline(), b.outline(), to_b);
      const double largest = largest_gap_by_definition(a.outline(), b.outline(), to_b);
      CHECK((found.gap > 0) == (largest > 0));
      // A separated verdict may stop at the first block that has a violated pair; a contact has seen all.
      if (largest <= 0) CHECK(found.gap == Approx(largest).margin(1e-15));
      if (largest > 0) CHECK(found.gap <= largest + 1e-15);
    }
  }
}

TEST_CASE("the deepest vertex is found from any hint") {
  Random random(14);
  for (int round = 0; round < 100; ++round) {
    const Shape<2> shape = shape_of(random_polygon(random, 300, 1));
    const Outline<2> o = shape.outline();
    const double angle = random.uniform(0, 7);
    const Vector<2> normal(std::cos(angle), std::sin(angle));
    const int deepest = deepest_vertex(o, normal);
    for (int hint = 0; hint < o.count; ++hint) CHECK(deepest_vertex(o, normal, hint) == deepest);
  }
}
