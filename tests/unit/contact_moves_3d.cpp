#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.h"
#include "contacts_3d.h"
#include "narrow_phase/space/potential_pairs.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

const Cloud cube = prism(rectangle(1, 1), 1);
const Cloud tip = octahedron(0.3, 0.3, 1);

}  // namespace

TEST_CASE(
    "at the pair of least depth a contact stays, and from any other pair it comes to one that holds it") {
  Random random(11);
  for (int i = 0; i < 60; ++i) {
    const Shape<3> a = random_block(random, random.integer(4, 24)),
                   b = random_block(random, random.integer(4, 24));
    const Vector<3> to_b = random_vector(random, -0.8, 0.8);
    const Separation<3> least = pair_of_largest_gap(a.outline(), b.outline(), to_b);
    if (least.gap > 0) continue;
    Pair pair = least.pair;
    Contact<3> contact;
    describe_contact(a.outline(), b.outline(), to_b, pair, {}, contact);
    const bool edges_in_face = least.pair.kind == Pair::edge_edge && pair.kind != Pair::edge_edge;
    if (edges_in_face) {
      // Nearly parallel to a face: its region stands in. Unit normals sin(angle) apart differ by that much,
      // and so do the gaps of blocks within 2 of each other.
      const Vector<3> normal = normal_of(a.outline(), b.outline(), pair);
      CHECK((normal - least.normal).norm() < 1.0001 * DetectOptions().region_angle());
      CHECK((contact.type == ContactType::face_face || contact.type == ContactType::edge_face));
      CHECK(contact.gap >= least.gap - 2 * 1.0001 * DetectOptions().region_angle());
    } else {
      CHECK(pair == least.pair);
      CHECK(contact.gap == Approx(least.gap).margin(1e-15));
    }
    check_by_definition(a, b, to_b, contact);
    for (int f = 0; f < a.face_count(); ++f) {
      Pair start{Pair::face_vertex, f, 0};
      const double gap = refresh(a.outline(), b.outline(), to_b, start);
      pair = start;
      describe_contact(a.outline(), b.outline(), to_b, pair, {}, contact);
      CHECK(contact.gap >= gap - 1e-15);
      // But for a region that leaves the deepest vertex out, the gap is that of all the two blocks have
      // there.
      Pair reached = pair;
      if (contact.type == ContactType::vertex_face || contact.type == ContactType::edge_edge)
        CHECK(contact.gap == Approx(refresh(a.outline(), b.outline(), to_b, reached)).margin(1e-15));
      check_by_definition(a, b, to_b, contact);
    }
  }
}

TEST_CASE("every facet of the Minkowski difference is across the sides of its neighbours") {
  Random random(5);
  for (int i = 0; i < 10; ++i) {
    const Shape<3> shape_a = random_block(random, 12), shape_b = random_block(random, 12);
    const Outline<3>&a = shape_a.outline(), &b = shape_b.outline();
    Pair first{Pair::face_vertex, 0, 0};
    refresh(a, b, Vector<3>::Zero(), first);
    std::vector<Pair> found{first};
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Pair pair = found[k];  // the list grows
      for_each_side(a, b, pair, [&](const FacetSide& side) {
        const Facet facet = facet_across(a, b, side, normal_of(a, b, pair));
        CHECK(facet.normal.isApprox(normal_of(a, b, facet.pair), 1e-9));
        if (std::find(found.begin(), found.end(), facet.pair) == found.end()) found.push_back(facet.pair);
      });
    }
    // By definition: each face with the vertex deepest behind it, and the edges that pass eqs. 23 and 24.
    int expected = a.face_count() + b.face_count();
    for (int e = 0; e < a.topology->edge_count; ++e)
      for (int h = 0; h < b.topology->edge_count; ++h)
        expected += is_edge_pair(SeenEdge(a, e), SeenEdge(b, h));
    CHECK(int(found.size()) == expected);
    for (Pair pair : found) {
      const Pair before = pair;
      refresh(a, b, Vector<3>::Zero(), pair);
      CHECK(pair == before);
    }
  }
}

TEST_CASE("a tip that slides over a cube's edge goes on at the next pair") {
  const Shape<3> block = block_of(cube), above = block_of(octahedron(0.3, 0.3, 0.3));
  Met met = meet(block, above, {0.4, 0.125, 0.79});
  REQUIRE(met.contact.type == ContactType::vertex_face);
  Pair last = met.witness.pair;
  int moves = 0;
  for (double x = 0.4; x < 0.7; x += 0.005) {
    met = meet(block, above, {x, 0.125, 0.79 - (x > 0.5 ? x - 0.5 : 0)}, met.witness);
    REQUIRE(met.contact.type != ContactType::none);
    CHECK(met.contact.normal.dot(Vector<3>(1, 0, 1)) > 0);
    CHECK(met.contact.gap > -0.02);
    moves += met.witness.pair != last;
    last = met.witness.pair;
  }
  CHECK(moves >= 1);
  CHECK(met.contact.normal.x() > 0.5);
}

TEST_CASE("edges that have ceased to be a potential pair lead on to one") {
  const Cloud ridge = wedge(1, 0.5, 0.5);
  const Shape<3> lower = block_of(ridge);
  Met met = meet(lower, turned_block(ridge, 0, 1), {0.1, 0, 0.99});
  REQUIRE(met.contact.type == ContactType::edge_edge);
  // The upper block turns until its faces are level: the edge that was its lowest is not any more.
  const Shape<3> upper = turned_block(ridge, pi / 4, 1);
  REQUIRE_FALSE(is_edge_pair(SeenEdge(lower.outline(), met.witness.pair.a),
                             SeenEdge(upper.outline(), met.witness.pair.b)));
  met = meet(lower, upper, {0.1, 0, 0.84}, met.witness);
  CHECK(met.contact.type == ContactType::edge_face);
  CHECK(met.contact.normal.isApprox(z_axis));
  check_by_definition(lower, upper, {0.1, 0, 0.84}, met.contact);
}

TEST_CASE(
    "in space, a thin block that is overlapped past its middle keeps the side through which it was met") {
  const Shape<3> slab = block_of(prism(rectangle(10, 10), 0.1)), above = block_of(octahedron(1, 1, 1));
  const Met apart = meet(slab, above, {0, 0, 1.06});
  REQUIRE(apart.contact.type == ContactType::none);
  const Met through = meet(slab, above, {0, 0, 0.96}, apart.witness);
  CHECK(through.contact.normal == z_axis);
  CHECK(through.contact.gap == Approx(-0.09));
  CHECK(meet(slab, above, {0, 0, -0.96}).contact.normal == -z_axis);
}

TEST_CASE("sides of a thin wedge that share an edge are not mixed up") {
  // A slice of triangles, 0.1 thick at its back and sharp at its front.
  const Shape<3> slice =
      block_of({{-5, -5, -0.05}, {-5, 5, -0.05}, {-5, -5, 0.05}, {-5, 5, 0.05}, {5, -5, 0}, {5, 5, 0}});
  const Shape<3> above = block_of(octahedron(1, 1, 1));
  const Met apart = meet(slice, above, {0, 0, 1.06});
  REQUIRE(apart.contact.type == ContactType::none);
  const Met through = meet(slice, above, {0, 0, 0.97}, apart.witness);
  CHECK(through.contact.normal.z() > 0.99);
  CHECK(through.contact.gap < -0.05);
}

TEST_CASE("from the violated pair the walk finds the side that is less deep, past facets in one plane") {
  const Shape<3> block = block_of(cube);
  for (const double angle : {0.0, 1e-12, 0.3}) {
    for (const Vector<3>& axis : {y_axis, z_axis}) {
      for (const double sign : {-1.0, 1.0}) {
        const Shape<3> other = block_of(turned(cube, angle, axis));
        const PairCache<3> through_side{PairCache<3>::separated, touching_through(block, x_axis).pair};
        const Met met = meet(block, other, 0.5 * x_axis + 0.9 * sign * axis, through_side);
        CHECK(met.contact.normal.isApprox(sign * axis));
        CHECK(met.contact.type == ContactType::face_face);
      }
    }
  }
}

TEST_CASE("edges that are parallel but for rounding are never across a side") {
  Random random(23);
  for (int i = 0; i < 20; ++i) {
    // Prisms along one direction, whichever it is.
    const Eigen::Matrix3d turn = random_rotation(random);
    const Shape<3> shape_a = block_of(turned(prism(regular_polygon(5, 1), 1), turn));
    const Shape<3> shape_b = block_of(turned(prism(regular_polygon(6, 0.7, 0.2), 2), turn));
    const Outline<3>&a = shape_a.outline(), &b = shape_b.outline();
    for (int f = 0; f < a.face_count(); ++f) {
      Pair pair{Pair::face_vertex, f, 0};
      refresh(a, b, Vector<3>::Zero(), pair);
      for_each_side(a, b, pair, [&](const FacetSide& side) {
        const Facet facet = facet_across(a, b, side, a.normal(f));
        if (facet.pair.kind != Pair::edge_edge) return;
        const Vector<3> along_a = edge_vector(a, facet.pair.a), along_b = edge_vector(b, facet.pair.b);
        CHECK(cross_product(along_a, along_b).norm() > 0.01);
      });
    }
  }
}

TEST_CASE("the walk ends at a pair less deep than all its neighbours") {
  Random random(17);
  for (int i = 0; i < 20; ++i) {
    const Shape<3> shape_a = random_block(random, 12), shape_b = random_block(random, 12);
    const Outline<3>&a = shape_a.outline(), &b = shape_b.outline();
    const Vector<3> to_b = random_vector(random, -0.4, 0.4);
    const Separation<3> least = pair_of_largest_gap(a, b, to_b);
    REQUIRE(least.gap < 0);
    for (int f = 0; f < a.face_count(); ++f) {
      Pair start{Pair::face_vertex, f, 0};
      const double gap_at_start = refresh(a, b, to_b, start);
      PairCache<3> witness{PairCache<3>::separated, start};
      remember_contact(a, b, to_b, least.pair, witness);
      const double gap = refresh(a, b, to_b, witness.pair);
      CHECK(gap >= gap_at_start);
      for_each_side(a, b, witness.pair, [&](const FacetSide& side) {
        Pair neighbour = facet_across(a, b, side, normal_of(a, b, witness.pair)).pair;
        CHECK(refresh(a, b, to_b, neighbour) <= gap);
      });
    }
  }
}

TEST_CASE("in space, the violated pair is tried first, and left when it no longer holds") {
  const Shape<3> block = block_of(cube), other = block_of(tip);
  const Met apart = meet(block, other, {0, 0, 1.6});
  REQUIRE(apart.witness.state == PairCache<3>::separated);
  PairCache<3> witness = apart.witness;
  CHECK(still_separated(block.outline(), other.outline(), {0.1, 0.1, 1.55}, witness));
  CHECK(witness.pair == apart.witness.pair);
  CHECK_FALSE(still_separated(block.outline(), other.outline(), {1, 0, 0}, witness));
}

TEST_CASE("a plane between blocks is kept until it no longer holds") {
  const Shape<3> block = block_of(cube), other = block_of(tip);
  const Outline<3>&a = block.outline(), &b = other.outline();
  const Vector<3> diagonal = Vector<3>(1, 1, 1).normalized();
  PairCache<3> witness{PairCache<3>::separated, {Pair::vertex_vertex, 0, 0}, diagonal};
  // Along it the cube reaches 1.5 / sqrt(3) and the tip 1 / sqrt(3).
  const Vector<3> apart = 2.51 / std::sqrt(3) * diagonal, together = 2.49 / std::sqrt(3) * diagonal;
  CHECK(still_separated(a, b, apart, witness));
  CHECK(witness.proof == diagonal);
  CHECK_FALSE(still_separated(a, b, together, witness));
  // From there the blocks meet through a face that looks along the plane, whatever vertices are remembered.
  CHECK(normal_of(a, b, initial_pair(a, b, together, witness)).dot(diagonal) > 0.57);
}

TEST_CASE("a fast block of many vertices that is all but through a thin plate keeps the side it came from") {
  Random random(31);
  const Shape<3> plate = block_of(prism(rectangle(10, 10), 0.1));
  for (int i = 0; i < 100; ++i) {
    const Shape<3> block = random_block(random, 60);
    const Outline<3>&a = plate.outline(), &b = block.outline();
    const auto [lowest, highest] = std::minmax_element(b.z, b.z + b.vertex_count());
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
    PairCache<3> witness, none;
    judge_pair(a, b, Vector<3>(x, y, 0.05 - *lowest + 0.03), witness);
    REQUIRE(witness.state == PairCache<3>::separated);
    const Vector<3> within(x, y, -0.05 - *highest + 0.03);
    judge_pair(a, b, within, witness);
    REQUIRE(witness.state == PairCache<3>::touching);
    CHECK(normal_of(a, b, witness.pair).z() > 0.9);
    // Without its history it is pushed on.
    judge_pair(a, b, within, none);
    CHECK(normal_of(a, b, none.pair).z() < -0.9);
  }
}

TEST_CASE("what is remembered saves searches along a motion, and never changes the verdict") {
  Random random(41);
  int steps = 0, proven = 0, changes = 0;
  for (int i = 0; i < 100; ++i) {
    const Cloud points = random_cloud(random, random.integer(4, 40), 0.6, 1);
    const Shape<3> shape_a = random_block(random, random.integer(4, 40));
    const Vector<3> axis = random_direction(random), from = random.uniform(1, 2) * axis;
    const Vector<3> path = 0.4 * random_direction(random);
    PairCache<3> witness;
    for (double time = 0; time < 1; time += 0.02) {
      const Shape<3> shape_b = block_of(turned(points, 0.2 * time, axis));
      const Outline<3>&a = shape_a.outline(), &b = shape_b.outline();
      const Vector<3> to_b = from + time * path;
      const PairCache<3>::State before = witness.state;
      const bool is_proven = still_separated(a, b, to_b, witness) || still_touching(a, b, to_b, witness);
      if (!still_separated(a, b, to_b, witness)) judge_pair(a, b, to_b, witness);
      CHECK((witness.state == PairCache<3>::separated) == (find_separation(a, b, to_b).gap > 0));
      ++steps;
      proven += is_proven;
      changes += time > 0 && witness.state != before;
      if (is_proven) CHECK(witness.state == before);
      if (witness.state == PairCache<3>::separated) continue;
      Contact<3> contact;
      describe_contact(a, b, to_b, witness, {}, contact);
    }
  }
  CHECK(changes > 10);
  CHECK(proven > 0.9 * steps);
}

TEST_CASE("a contact that is known by its description is the one that is found when it is judged first") {
  Random random(43);
  int known = 0, touching = 0;
  for (int i = 0; i < 100; ++i) {
    const Cloud points = random_cloud(random, random.integer(4, 40), 0.6, 1);
    const Shape<3> shape_a = random_block(random, random.integer(4, 40));
    const Vector<3> axis = random_direction(random), path = 0.05 * random_direction(random);
    const Outline<3>& a = shape_a.outline();
    PairCache<3> witness, judged;
    Vector<3> from = 2 * axis;
    for (double time = 0; time < 1; time += 0.05) {
      const Shape<3> shape_b = block_of(turned(points, 0.01 * time, axis));
      const Outline<3>& b = shape_b.outline();
      // Onto each other until they overlap, and then on.
      if (time == 0) {
        const Separation<3> apart = find_separation(a, b, from);
        from -= (apart.gap + 0.02) * apart.normal;
      }
      const Vector<3> to_b = from + time * path;
      Contact<3> contact, described;
      PairCache<3> before = witness;
      known += describe_plainly_touching(a, b, to_b, before, {}, contact);
      const bool found = find_contact(a, b, to_b, {}, witness, contact);
      if (!still_separated(a, b, to_b, judged)) judge_pair(a, b, to_b, judged);
      REQUIRE(found == (judged.state == PairCache<3>::touching));
      REQUIRE(found == (find_separation(a, b, to_b).gap <= 0));
      if (!found) continue;
      ++touching;
      describe_contact<3>(a, b, to_b, judged, {}, described);
      CHECK(contact.type == described.type);
      CHECK(contact.pair == described.pair);
      CHECK(witness.pair == judged.pair);
      CHECK(contact.gap == described.gap);
      CHECK(contact.normal == described.normal);
      CHECK(contact.center == described.center);
    }
  }
  CHECK(touching > 200);
  CHECK(known > touching / 5);  // those at a point, as a rule
}

TEST_CASE("no memory, whatever it holds, makes blocks touch or lie apart that do not") {
  const Shape<3> block = block_of(cube);
  const Outline<3>& o = block.outline();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const Vector<3>& proof :
       {Vector<3>(0, 0, 0), Vector<3>(0.5, 0, 0), Vector<3>(nothing, 0, 0), Vector<3>(HUGE_VAL, 0, 0)}) {
    for (const auto state : {PairCache<3>::separated, PairCache<3>::touching}) {
      for (const double x : {0.75, 1.25}) {
        PairCache<3> witness{state, {Pair::vertex_vertex, 0, 0}, proof};
        if (state == PairCache<3>::touching) witness.pair = {Pair::face_vertex, 0, 0};
        if (!still_separated(o, o, {x, 0.1, 0.2}, witness)) judge_pair(o, o, {x, 0.1, 0.2}, witness);
        CHECK((witness.state == PairCache<3>::touching) == (x < 1));
      }
    }
  }
}
