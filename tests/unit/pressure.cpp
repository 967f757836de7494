#include "catch.h"
#include "force/spring/pressure_room.h"
#include "geometry/polygon/cut.h"
#include "narrow_phase/plane/separation.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

struct PolygonPair {
  Shape<2> a, b;
  Vector<2> to_b;
};

/// Two polygons that overlap.
PolygonPair draw_pair(Random& random) {
  for (;;) {
    const Points p = random_polygon(random, 12, 1), q = random_polygon(random, 12, 1);
    const double angle = random.uniform(0, 7), distance = random.uniform(0.1, 1.9);
    const Vector<2> to_b = distance * Vector<2>(std::cos(angle), std::sin(angle));
    if (find_separation(shape_of(p).outline(), shape_of(q).outline(), to_b).gap < -1e-3)
      return {shape_of(p), shape_of(q), to_b};
  }
}

Pressure<2> pressure_of(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b,
                        const PotentialPair<2>& near) {
  PressureRoom<2> room(memory);
  return pressure_between(a.outline(), b.outline(), to_b, near, room);
}
Pressure<2> pressure_of(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b) {
  return pressure_of(a, b, to_b, find_separation(a.outline(), b.outline(), to_b).pair);
}
Pressure<2> pressure_of(const PolygonPair& pair) { return pressure_of(pair.a, pair.b, pair.to_b); }

/// The overlap by cutting, relative to the centroid of a.
Points overlap_by_cutting(const PolygonPair& pair) {
  const Outline<2> oa = pair.a.outline(), ob = pair.b.outline();
  Points part;
  for (int i = 0; i < ob.count; ++i) part.push_back(ob.vertex(i) + pair.to_b);
  for (int edge = 0; edge < oa.count && !part.empty(); ++edge) {
    const auto parts = cut_polygon(part, oa.vertex(edge), oa.normal(edge), memory);
    part.assign(parts.behind.begin(), parts.behind.end());
  }
  return part;
}

/// The least energy by definition: a linear depth over an area is the area times the depth at its centroid.
double least_energy(const PolygonPair& pair) {
  const Points part = overlap_by_cutting(pair);
  double twice_area = 0;
  Vector<2> moment = Vector<2>::Zero();
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    const double twice = cross(part[i] - part[0], part[i + 1] - part[0]);
    twice_area += twice;
    moment += twice / 3 * (part[0] + part[i] + part[i + 1]);
  }
  const Vector<2> centroid = moment / twice_area;
  double least = HUGE_VAL;
  const auto look = [&](const Outline<2>& block, const Vector<2>& p) {
    for (int e = 0; e < block.count; ++e) least = std::min(least, block.offset[e] - block.normal(e).dot(p));
  };
  look(pair.a.outline(), centroid);
  look(pair.b.outline(), centroid - pair.to_b);
  return 0.5 * twice_area * least;
}

Shape<2> strained(const Shape<2>& shape, const Tensor<2>& by) {
  Points points;
  for (int i = 0; i < shape.outline().count; ++i)
    points.push_back(shape.outline().vertex(i) + by * shape.outline().vertex(i));
  return shape_of(points);
}

}  // namespace

TEST_CASE("a square on a longer one: force, energy, base and middle are exact") {
  const PolygonPair pair{shape_of(rectangle(4, 2)), shape_of(rectangle(2, 2)), {0.5, 1.75}};
  const Pressure<2> pressure = pressure_of(pair);
  CHECK(pressure.normal == Vector<2>(0, 1));
  CHECK(pressure.force.isApprox(Vector<2>(0, 0.25 * 2), 1e-15));
  CHECK(pressure.energy == Approx(0.5 * 0.25 * 0.25 * 2).epsilon(1e-15));
  CHECK(pressure.base == Approx(2).epsilon(1e-15));
  CHECK(pressure.middle.isApprox(Vector<2>(0.5, 0.875), 1e-14));
  CHECK(pressure.spread.isApprox(Tensor<2>(Vector<2>(4.0 / 12, 0).asDiagonal()), 1e-14));
  CHECK(pressure.couple()[0] == Approx(0).margin(1e-15));
}

TEST_CASE("a square over the end of another is pushed off by the pressure on its side") {
  const PolygonPair pair{shape_of(rectangle(4, 2)), shape_of(rectangle(2, 2)), {2, 1.75}};
  const Pressure<2> pressure = pressure_of(pair);
  CHECK(pressure.force.isApprox(Vector<2>(0.5 * 0.25 * 0.25, 0.25), 1e-15));
}

TEST_CASE("over a joint of two blocks the forces are those of one") {
  const Shape<2> tile = shape_of(rectangle(2, 2)), whole = shape_of(rectangle(4, 2));
  Random random(8);
  for (int round = 0; round < 100; ++round) {
    const Shape<2> block = shape_of(random_polygon(random, 8, 0.5));
    double lowest = 0;
    for (int i = 0; i < block.outline().count; ++i) lowest = std::min(lowest, block.outline().vertex(i).y());
    const Vector<2> at(random.uniform(-0.3, 0.3), 1 - lowest - random.uniform(1e-4, 0.05));
    const Pressure<2> left = pressure_of(tile, block, at + Vector<2>(1, 0)),
                      right = pressure_of(tile, block, at - Vector<2>(1, 0)),
                      one = pressure_of(whole, block, at);
    const auto is_on_top = [](const Pressure<2>& part) {
      return part.is_empty() || (part.owner == 0 && part.face_normal.y() == 1);
    };
    if (!is_on_top(left) || !is_on_top(right)) continue;
    CHECK((left.force + right.force - one.force).norm() < 1e-15);
    CHECK((left.virial_b(at + Vector<2>(1, 0)) + right.virial_b(at - Vector<2>(1, 0)) - one.virial_b(at))
              .norm() < 1e-15);
    CHECK(left.base + right.base == Approx(one.base).epsilon(1e-13));
  }
}

TEST_CASE("the energy is the least of all faces, from whichever face the search starts") {
  Random random(21);
  for (int round = 0; round < 1000; ++round) {
    const PolygonPair pair = draw_pair(random);
    // Cutting rounds its new corners to the ulp of a unit coordinate.
    const double energy = least_energy(pair);
    CHECK(pressure_of(pair).energy == Approx(energy).margin(1e-14));
    const int edges[] = {pair.a.outline().count, pair.b.outline().count};
    const int owner = random.integer(0, 1);
    const Pressure<2> found =
        pressure_of(pair.a, pair.b, pair.to_b, {owner, random.integer(0, edges[owner] - 1), 0});
    CHECK(found.energy == Approx(energy).margin(1e-14));
  }
}

TEST_CASE("force and virials of a pressure are the gradient of its energy as blocks move and are strained") {
  Random random(66);
  constexpr double step = 1e-5;
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    const PolygonPair pair = draw_pair(random);
    const Tensor<2> rate_a = random_tensor<2>(random), rate_b = random_tensor<2>(random);
    const Vector<2> velocity(random.uniform(-1, 1), random.uniform(-1, 1));
    const auto after = [&](double time) {
      return pressure_of(strained(pair.a, time * rate_a), strained(pair.b, time * rate_b),
                         pair.to_b + time * velocity);
    };
    const Pressure<2> found = pressure_of(pair), later = after(step), earlier = after(-step);
    if (!(later.face == found.face) || !(earlier.face == found.face))
      continue;  // the energy has a kink between
    const double power = found.force.dot(velocity) + found.virial_a().cwiseProduct(rate_a).sum() +
                         found.virial_b(pair.to_b).cwiseProduct(rate_b).sum();
    // The force has a bounded derivative but where a corner enters or leaves.
    CHECK(std::abs((later.energy - earlier.energy) / (2 * step) + power) <= 40 * step);
    ++compared;
  }
  CHECK(compared > 250);
}

TEST_CASE("a pressure seen from the other block is opposite") {
  Random random(63);
  for (int round = 0; round < 1000; ++round) {
    const PolygonPair pair = draw_pair(random);
    const Pressure<2> on_b = pressure_of(pair), on_a = pressure_of(pair.b, pair.a, -pair.to_b);
    CHECK((on_b.middle - on_a.middle - pair.to_b).norm() <= 1e-13);
    CHECK((on_b.force + on_a.force).norm() <= 1e-14);
    CHECK((on_b.virial_a() - on_a.virial_b(-pair.to_b)).norm() <= 1e-14);
    CHECK((on_b.virial_b(pair.to_b) - on_a.virial_a()).norm() <= 1e-14);
    CHECK(std::abs((moment(on_b.virial_a()) + moment(on_b.virial_b(pair.to_b)))[0] +
                   cross(pair.to_b, on_b.force)) <= 1e-14);
  }
}

TEST_CASE("rounding does not decide on whose side the pressure of flush blocks acts") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  for (const double off : {0.0, 1e-15, -1e-15, 1e-10, -1e-10}) {
    const Pressure<2> pressure = pressure_of(square, square, {off, 1.875});
    CHECK(std::abs(pressure.force.x()) <= 1e-16);
    CHECK(pressure.force.y() == Approx(0.125 * 2).epsilon(1e-9));
    CHECK(pressure.energy == Approx(0.5 * 0.125 * 0.125 * 2).epsilon(1e-9));
  }
}

TEST_CASE("a pressure found from its own face has the same bits") {
  Random random(74);
  for (int round = 0; round < 200; ++round) {
    const PolygonPair pair = draw_pair(random);
    const PotentialPair<2> start{0, random.integer(0, pair.a.outline().count - 1), 0};
    const Pressure<2> found = pressure_of(pair.a, pair.b, pair.to_b, start),
                      again = pressure_of(pair.a, pair.b, pair.to_b, found.face);
    CHECK(again.energy == found.energy);
    CHECK(again.force == found.force);
    CHECK(again.virial == found.virial);
    CHECK(again.middle == found.middle);
  }
}

TEST_CASE("flush blocks keep the face of their pressure, although rounding tells between theirs") {
  Random random(75);
  int other_faces = 0;
  for (int round = 0; round < 1000; ++round) {
    const double angle = random.uniform(-3, 3);
    const auto turned = [&](const Points& points) {
      Points all;
      for (const Vector<2>& p : points) all.push_back(Rotation<2>().turned_by(Angular<2>(angle)) * p);
      return shape_of(all);
    };
    const Shape<2> floor = turned(rectangle(20, 2)), box = turned(rectangle(2, 2));
    const Vector<2> to_b =
        Rotation<2>().turned_by(Angular<2>(angle)) * Vector<2>(random.uniform(-5, 5), 1.99);
    const PotentialPair<2> start{0, 2, 0};
    const Pressure<2> found = pressure_of(floor, box, to_b, start),
                      again = pressure_of(floor, box, to_b, found.face);
    other_faces += !(again.face == found.face);
    CHECK(found.face.owner == found.owner);
    CHECK(again.energy == found.energy);
    CHECK(again.force == found.force);
    CHECK(again.middle == found.middle);
  }
  CHECK(other_faces == 0);
}
