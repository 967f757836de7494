#include "catch.h"
#include "contacts_3d.h"
#include "force/spring/pressure_room.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

struct BodyPair {
  Shape<3> a, b;
  Vector<3> to_b;
};

BodyPair draw_pair(Random& random, int max_vertices = 24) {
  for (;;) {
    const Cloud p = random_cloud(random, random.integer(4, max_vertices), 1, 1),
                q = random_cloud(random, random.integer(4, max_vertices), 1, 1);
    const Vector<3> to_b = random_vector(random, -0.8, 0.8);
    if (pair_of_largest_gap(block_of(p).outline(), block_of(q).outline(), to_b).gap < -1e-3)
      return {block_of(p), block_of(q), to_b};
  }
}

Pressure<3> pressure_of(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b,
                        const PotentialPair<3>& near) {
  PressureRoom<3> room(memory);
  return pressure_between(a.outline(), b.outline(), to_b, near, room);
}
Pressure<3> pressure_of(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b) {
  return pressure_of(a, b, to_b, pair_of_largest_gap(a.outline(), b.outline(), to_b).pair);
}
Pressure<3> pressure_of(const BodyPair& pair) { return pressure_of(pair.a, pair.b, pair.to_b); }

Shape<3> strained(const Shape<3>& shape, const Tensor<3>& by) {
  Cloud points;
  for (int v = 0; v < shape.outline().vertex_count(); ++v)
    points.push_back(shape.outline().vertex(v) + by * shape.outline().vertex(v));
  return block_of(points);
}

}  // namespace

TEST_CASE("in space, a cube on a larger one: force, energy, base and middle are exact") {
  const BodyPair pair{
      block_of(prism(rectangle(4, 4), 2)), block_of(prism(rectangle(1, 2), 2)), {0.5, 0.25, 1.75}};
  const Pressure<3> pressure = pressure_of(pair);
  CHECK(pressure.normal == Vector<3>(0, 0, 1));
  CHECK(pressure.force.isApprox(Vector<3>(0, 0, 0.25 * 2), 1e-15));
  CHECK(pressure.energy == Approx(0.5 * 0.25 * 0.25 * 2).epsilon(1e-15));
  CHECK(pressure.base == Approx(2).epsilon(1e-15));
  CHECK(pressure.middle.isApprox(Vector<3>(0.5, 0.25, 0.875), 1e-14));
  CHECK(pressure.spread.isApprox(Tensor<3>(Vector<3>(1.0 / 12, 4.0 / 12, 0).asDiagonal()), 1e-14));
  CHECK(pressure.couple().norm() <= 1e-15);
}

TEST_CASE("in space, over joints that cross, the forces are those of one block") {
  const Shape<3> tile = block_of(prism(rectangle(2, 2), 2)), whole = block_of(prism(rectangle(4, 4), 2));
  Random random(8);
  int compared = 0;
  for (int round = 0; round < 100; ++round) {
    const Shape<3> block = random_block(random, 12);
    double lowest = 0;
    for (int v = 0; v < block.outline().vertex_count(); ++v)
      lowest = std::min(lowest, block.outline().vertex(v).z());
    const Vector<3> at(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                       1 - lowest - random.uniform(1e-4, 0.05));
    const Pressure<3> one = pressure_of(whole, block, at);
    Vector<3> force = Vector<3>::Zero();
    Tensor<3> virial = Tensor<3>::Zero();
    double base = 0;
    bool on_top = one.owner == 0 && one.face_normal.z() == 1;
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        const Vector<3> to_block = at - Vector<3>(x, y, 0);
        if (pair_of_largest_gap(tile.outline(), block.outline(), to_block).gap > 0) continue;
        const Pressure<3> part = pressure_of(tile, block, to_block);
        on_top &= part.is_empty() || (part.owner == 0 && part.face_normal.z() == 1);
        force += part.force;
        virial += part.virial_b(to_block);
        base += part.base;
      }
    }
    if (!on_top) continue;
    CHECK((force - one.force).norm() < 1e-15);
    CHECK((virial - one.virial_b(at)).norm() < 1e-15);
    CHECK(base == Approx(one.base).epsilon(1e-12));
    ++compared;
  }
  CHECK(compared > 40);
}

TEST_CASE("in space, the energy is the least of all faces, from whichever face the search starts") {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const BodyPair pair = draw_pair(random);
    const Polyhedron part = intersection_by_cutting(pair.a, pair.b, pair.to_b);
    if (part.is_empty()) continue;
    // A linear depth over a volume is the volume times the depth at its centroid.
    const Shape<3> body(part, memory);
    double least = HUGE_VAL;
    const auto look = [&](const Outline<3>& block, const Vector<3>& p) {
      for (int f = 0; f < block.face_count(); ++f)
        least = std::min(least, block.offset[f] - block.normal(f).dot(p));
    };
    look(pair.a.outline(), body.centroid());
    look(pair.b.outline(), body.centroid() - pair.to_b);
    const double energy = body.volume() * least;
    CHECK(pressure_of(pair).energy == Approx(energy).margin(1e-13));
    const PotentialPair<3> of_a{PotentialPair<3>::face_vertex, random.integer(0, pair.a.face_count() - 1), 0},
        of_b{PotentialPair<3>::vertex_face, 0, random.integer(0, pair.b.face_count() - 1)};
    CHECK(pressure_of(pair.a, pair.b, pair.to_b, of_a).energy == Approx(energy).margin(1e-13));
    CHECK(pressure_of(pair.a, pair.b, pair.to_b, of_b).energy == Approx(energy).margin(1e-13));
  }
}

TEST_CASE("in space, force and virials of a pressure are the gradient of its energy") {
  Random random(72);
  constexpr double step = 1e-6;
  int compared = 0;
  for (int round = 0; round < 100; ++round) {
    const BodyPair pair = draw_pair(random, 12);
    const Tensor<3> rate_a = random_tensor<3>(random) / 3, rate_b = random_tensor<3>(random) / 3;
    const Vector<3> velocity = random_direction(random);
    const auto after = [&](double time) {
      return pressure_of(strained(pair.a, time * rate_a), strained(pair.b, time * rate_b),
                         pair.to_b + time * velocity);
    };
    const Pressure<3> found = pressure_of(pair), later = after(step), earlier = after(-step);
    const auto has_turned = [&](const Pressure<3>& moved) {
      return (moved.face_normal - found.face_normal).norm() > 10 * step;
    };
    if (has_turned(later) || has_turned(earlier)) continue;  // the energy has a kink between
    const double power = found.force.dot(velocity) + found.virial_a().cwiseProduct(rate_a).sum() +
                         found.virial_b(pair.to_b).cwiseProduct(rate_b).sum();
    CHECK(std::abs((later.energy - earlier.energy) / (2 * step) + power) <= 40 * step);
    ++compared;
  }
  CHECK(compared > 80);
}

TEST_CASE("in space, a pressure seen from the other block is opposite") {
  Random random(73);
  for (int round = 0; round < 200; ++round) {
    const BodyPair pair = draw_pair(random);
    const Pressure<3> on_b = pressure_of(pair), on_a = pressure_of(pair.b, pair.a, -pair.to_b);
    CHECK((on_b.middle - on_a.middle - pair.to_b).norm() <= 1e-13);
    CHECK((on_b.force + on_a.force).norm() <= 1e-13);
    CHECK((on_b.virial_a() - on_a.virial_b(-pair.to_b)).norm() <= 1e-13);
    CHECK((on_b.virial_b(pair.to_b) - on_a.virial_a()).norm() <= 1e-13);
    CHECK((moment(on_b.virial_a()) + moment(on_b.virial_b(pair.to_b)) + cross_product(pair.to_b, on_b.force))
              .norm() <= 1e-13);
  }
}

TEST_CASE("the pressure between faces of many corners and blocks of many vertices") {
  const BodyPair pair{block_of(prism(regular_polygon(100, 1), 1)),
                      block_of(prism(regular_polygon(70, 1, 0.1), 1)),
                      {0.1, 0.2, 0.9}};
  const Pressure<3> pressure = pressure_of(pair);
  const Shape<3> body(intersection_by_cutting(pair.a, pair.b, pair.to_b), memory);
  CHECK(std::abs(pressure.face_normal.dot(pressure.force)) == Approx(body.volume()).epsilon(1e-12));
  CHECK(pressure.base == Approx(body.volume() / 0.1).epsilon(1e-12));
  CHECK(pressure.energy == Approx(0.5 * body.volume() * 0.1).epsilon(1e-12));
}

TEST_CASE("in space, rounding does not decide on whose side the pressure of flush blocks acts") {
  const Shape<3> cube = block_of(prism(rectangle(2, 2), 2));
  for (const double off : {0.0, 1e-15, -1e-15, 1e-10, -1e-10}) {
    const Pressure<3> pressure = pressure_of(cube, cube, {off, -0.5 * off, 1.875});
    CHECK(pressure.force.head<2>().norm() <= 1e-16);
    CHECK(pressure.force.z() == Approx(0.125 * 4).epsilon(1e-9));
    CHECK(pressure.energy == Approx(0.5 * 0.125 * 0.125 * 4).epsilon(1e-9));
  }
}

TEST_CASE("in space, a pressure found from its own face has the same bits") {
  Random random(74);
  for (int round = 0; round < 200; ++round) {
    const BodyPair pair = draw_pair(random);
    const PotentialPair<3> start{PotentialPair<3>::face_vertex, random.integer(0, pair.a.face_count() - 1),
                                 0};
    const Pressure<3> found = pressure_of(pair.a, pair.b, pair.to_b, start),
                      again = pressure_of(pair.a, pair.b, pair.to_b, found.face);
    CHECK(again.energy == found.energy);
    CHECK(again.force == found.force);
    CHECK(again.virial == found.virial);
    CHECK(again.middle == found.middle);
  }
}
