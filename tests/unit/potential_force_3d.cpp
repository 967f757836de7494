#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "force/potential/potential_force.h"
#include "geometry/polyhedron/cut.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

PotentialForce<3> force_between(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b) {
  PotentialRoom<3> room(memory);
  return potential_force(a.outline(), b.outline(), to_b, room);
}

Shape<3> box_of(const Vector<3>& size) { return shape_of(completed(box(size))); }

Cloud vertices_of(const Shape<3>& shape) {
  Cloud vertices;
  for (int v = 0; v < shape.vertex_count(); ++v) vertices.push_back(shape.outline().vertex(v));
  return vertices;
}

struct PlacedPair {
  Shape<3> a, b;
  Vector<3> to_b;
};

/// From just touching to one inside the other; a within a ball of radius 1 about its centroid, or little
/// more.
PlacedPair draw_pair(Random& random, int max_vertices) {
  const double distance = random.uniform(0, 1.6);
  const Vector<3> to_b = distance * random_direction(random);
  const double size = random.uniform(0.2, 1);
  return {random_block(random, random.integer(4, max_vertices)),
          block_of(scaled(random_cloud(random, random.integer(4, max_vertices), 1, 1), size)), to_b};
}

/// What two blocks have in common lies in a ball of radius 1, and so its surface is at most 4 pi. When b
/// moves, the force of a's potential, that is its integral over the part of b's surface inside a, changes by
/// at most the area of this part times the way; and likewise that of b's potential.
constexpr double most_rate = 4 * pi;

/// A block's potential, as the paper has it.
struct Potential {
  const Outline<3>& owner;
  Vector<3> at;

  double depth(int face, const Vector<3>& p) const {
    return owner.offset[face] - owner.normal(face).dot(p - at);
  }
  double operator()(const Vector<3>& p) const {
    double least = depth(0, p);
    for (int f = 1; f < owner.face_count(); ++f) least = std::min(least, depth(f, p));
    return std::max(least, 0.0);
  }
};

struct ForceAndMoment {
  Vector<3> force = Vector<3>::Zero();
  Vector<3> moment = Vector<3>::Zero();
};

/// Integral of a potential over a polygon, along its normal. The polygon is parted along every line where it
/// is equally deep behind two faces; in between the potential is linear, and its product with the position
/// quadratic, for which the middles of a triangle's sides are exact.
void integrate(const Potential& potential, const Vector<3>& normal, const Cloud& polygon, int e, int f,
               ForceAndMoment& sum) {
  const int count = potential.owner.face_count();
  if (f == count) return integrate(potential, normal, polygon, e + 1, e + 2, sum);
  if (e + 1 < count) {
    Cloud parts[2];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector<3>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double at_p = potential.depth(e, p) - potential.depth(f, p),
                   at_q = potential.depth(e, q) - potential.depth(f, q);
      parts[at_p > 0].push_back(p);
      if ((at_p > 0) == (at_q > 0)) continue;
      for (Cloud& part : parts) part.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    for (const Cloud& part : parts)
      if (part.size() >= 3) integrate(potential, normal, part, e, f + 1, sum);
    return;
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector<3>&p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
    const double third = 0.5 * normal.dot(cross_product(q - p, r - p)) / 3;
    for (const Vector<3>& middle :
         {Vector<3>(0.5 * (p + q)), Vector<3>(0.5 * (q + r)), Vector<3>(0.5 * (r + p))}) {
      const Vector<3> force = third * potential(middle) * normal;
      sum.force += force;
      sum.moment += cross_product(middle, force);
    }
  }
}

ForceAndMoment surface_integral(const Potential& potential, const Polyhedron& intersection) {
  ForceAndMoment sum;
  for (int face = 0; face < intersection.face_count(); ++face) {
    Cloud polygon;
    for (const std::int32_t v : intersection.loop(face))
      polygon.push_back(intersection.vertices[std::size_t(v)]);
    integrate(potential, intersection.normals[std::size_t(face)], polygon, 0, 1, sum);
  }
  return sum;
}

/// The forces on b and a balance, and so do their moments about the centroid of a. When everything grows
/// about it, the energy does by the fourth power.
void check_balance(const PotentialForce<3>& found, const Vector<3>& to_b) {
  // Of sums of some hundred products of numbers up to 1.
  constexpr double rounding = 1e-13;
  CHECK((moment(found.virial_a) + moment(found.virial_b) + moment(to_b, found.force)).norm() <= rounding);
  CHECK(std::abs(found.virial_a.trace() + found.virial_b.trace() + to_b.dot(found.force) +
                 4 * found.energy) <= rounding);
}

}  // namespace

TEST_CASE("aligned faces push with twice the frustum over which each is the nearest") {
  constexpr double side = 2;
  const Shape<3> cube = box_of({side, side, side});
  for (const double depth : {1e-6, 0.01, 0.25, 0.9}) {
    const PotentialForce<3> found = force_between(cube, cube, {0, 0, side - depth});
    const auto power = [&](int k) { return std::pow(depth, k); };
    const double frustum = side * side * depth - 2 * side * power(2) + 4 * power(3) / 3;
    const double stored = side * side * power(2) - 4 * side * power(3) / 3 + 2 * power(4) / 3;
    // To the rounding of the depth, that is of 1.
    CHECK(found.force.z() == Approx(2 * frustum).epsilon(1e-9));
    CHECK(std::abs(found.force.x()) <= 1e-14);
    CHECK(std::abs(found.force.y()) <= 1e-14);
    CHECK(moment(found.virial_a).norm() <= 1e-14);
    CHECK(found.energy == Approx(stored).epsilon(1e-9));
    CHECK(found.content == Approx(side * side * depth).epsilon(1e-9));
    CHECK((found.centroid - Vector<3>(0, 0, 1 - depth / 2)).norm() <= 1e-9);
    check_balance(found, {0, 0, side - depth});
  }
}

TEST_CASE(
    "a corner that dips into a face is pushed with its volume, and its own faces with three thirds of it") {
  // The corner of a cube, diagonal upright, over the middle of a plate's upper face.
  const Shape<3> plate = box_of({10, 10, 2});
  const Eigen::Matrix3d upright =
      Eigen::Quaterniond::FromTwoVectors(Vector<3>(1, 1, 1), Vector<3>(0, 0, 1)).toRotationMatrix();
  const Shape<3> cube = block_of(turned(vertices_of(box_of({1, 1, 1})), upright));
  for (const double depth : {1e-3, 0.1}) {
    const Vector<3> to_b(0.3, 0.2, 1 - depth + std::sqrt(0.75));
    const PotentialForce<3> found = force_between(plate, cube, to_b);
    // A corner of three right angles: edges as long as the depth times the root of 3.
    const double volume = std::pow(depth, 3) * std::sqrt(3.0) / 2;
    CHECK(found.content == Approx(volume).epsilon(1e-9));
    // The cube's faces lean by the angle whose cosine is 1 / sqrt(3).
    CHECK(found.force.z() == Approx(volume * (1 + 1 / std::sqrt(3.0))).epsilon(1e-9));
    CHECK(found.force.head<2>().norm() <= 1e-9 * volume);
    // A tetrahedron's centroid is at a quarter of its height. Seen from the cube's faces, each third of it is
    // a tetrahedron over a face's triangle with its top in the middle of the base.
    const double height_over_face = depth / std::sqrt(3.0);
    CHECK(found.energy == Approx(volume * (depth + height_over_face) / 4).epsilon(1e-9));
    CHECK((found.centroid - Vector<3>(0.3, 0.2, 1 - depth / 4)).norm() <= 1e-9);
  }
}

TEST_CASE("in space, forces and energy of blocks that are apart or only touch are 0") {
  const Shape<3> cube = box_of({2, 2, 2});
  for (const Vector<3>& to_b : {Vector<3>(0, 0, 2.5), Vector<3>(-2.1, 0.3, 0.2), Vector<3>(2.01, 2.01, 2.01),
                                Vector<3>(0, 0, 2), Vector<3>(2, 2, 0.5), Vector<3>(-2, 2, 2)}) {
    const PotentialForce<3> found = force_between(cube, cube, to_b);
    CHECK(found.force.isZero(0));
    CHECK(found.virial_a.isZero(0));
    CHECK(found.virial_b.isZero(0));
    CHECK(found.content == 0);
    CHECK(found.energy == 0);
  }
}

TEST_CASE("a block within another is pushed out by the other's potential alone") {
  const Shape<3> cube = box_of({2, 2, 2}), small = box_of({0.5, 0.25, 0.125});
  const PotentialForce<3> off = force_between(cube, small, {0, 0.1, 0.6});
  CHECK((off.force - Vector<3>(0, 0, small.volume())).norm() <= 1e-15);
  CHECK(off.content == Approx(small.volume()).epsilon(1e-14));
  CHECK((off.centroid - Vector<3>(0, 0.1, 0.6)).norm() <= 1e-14);
  // In the cube its depth at the centroid; in itself, box over box of the inner boxes, integrated.
  const double x = 0.5, y = 0.25, z = 0.125, h = z / 2;
  const double own = x * y * z * h - 2 * (x * y + y * z + z * x) * h * h / 2 +
                     4 * (x + y + z) * h * h * h / 3 - 8 * h * h * h * h / 4;
  CHECK(off.energy == Approx(small.volume() * 0.4 + own).epsilon(1e-12));

  const PotentialForce<3> same = force_between(cube, cube, {0, 0, 0});
  CHECK(same.force.norm() <= 1e-14);
  CHECK(same.content == Approx(8).epsilon(1e-14));
  CHECK(same.energy == Approx(4).epsilon(1e-14));  // twice the integral of (2 - 2 t)^3 over t from 0 to 1
}

TEST_CASE(
    "in space, force and moment are the integral of the potentials over the surface of the intersection") {
  Random random(71);
  int overlapping = 0;
  for (int round = 0; round < 400; ++round) {
    const PlacedPair pair = draw_pair(random, 8);
    const Shape<3>&a = pair.a, &b = pair.b;
    const Polyhedron intersection = intersection_by_cutting(a, b, pair.to_b);
    const PotentialForce<3> found = force_between(a, b, pair.to_b);
    check_balance(found, pair.to_b);
    ForceAndMoment expected;  // on b, about the centroid of a
    if (!intersection.is_empty()) {
      const ForceAndMoment by_a = surface_integral({a.outline(), Vector<3>::Zero()}, intersection),
                           by_b = surface_integral({b.outline(), pair.to_b}, intersection);
      expected = {by_b.force - by_a.force, by_b.moment - by_a.moment};
      ++overlapping;
    }
    // Both ways sum some hundred products of numbers up to 1; cutting with its tolerances is off by more.
    CHECK((found.force - expected.force).norm() <= 1e-12);
    CHECK((moment(found.virial_a) + expected.moment).norm() <= 1e-12);
    if (intersection.is_empty()) continue;
    const Shape<3> body(intersection, memory);
    CHECK(found.content == Approx(body.volume()).margin(1e-13));
    if (body.volume() > 1e-5) CHECK((found.centroid - body.centroid()).norm() <= 1e-13 / body.volume());
  }
  CHECK(overlapping > 150);
}

TEST_CASE(
    "in space, force and virials are the gradient of the energy as either block moves, turns and is "
    "strained") {
  Random random(72);
  constexpr double step = 1e-6;
  for (const int max_vertices : {4, 8, 12, 32, 128}) {
    for (int round = 0; round < 20; ++round) {
      const PlacedPair pair = draw_pair(random, max_vertices);
      const Tensor<3> rate_a = random_tensor<3>(random) / 3, rate_b = random_tensor<3>(random) / 3;
      const Vector<3> velocity = random_direction(random);
      const auto energy_after = [&](double time, double moves, double strains) {
        const auto strained = [&](const Shape<3>& shape, const Tensor<3>& rate) {
          Cloud points;
          for (const Vector<3>& p : vertices_of(shape)) points.push_back(p + strains * time * (rate * p));
          return block_of(points);
        };
        return force_between(strained(pair.a, rate_a), strained(pair.b, rate_b),
                             pair.to_b + moves * time * velocity)
            .energy;
      };
      const auto slope = [&](double moves, double strains) {
        return (energy_after(step, moves, strains) - energy_after(-step, moves, strains)) / (2 * step);
      };
      const PotentialForce<3> found = force_between(pair.a, pair.b, pair.to_b);
      // The force changes by at most most_rate times the way; rounding of the energy over the step is less.
      CHECK(std::abs(slope(1, 0) + found.force.dot(velocity)) <= most_rate * step);
      // No point moves faster than 1, and the normals turn no faster, by which the depth changes at twice the
      // rate.
      const double power =
          found.virial_a.cwiseProduct(rate_a).sum() + found.virial_b.cwiseProduct(rate_b).sum();
      CHECK(std::abs(slope(0, 1) + power) <= 4 * most_rate * step);
    }
  }
}

TEST_CASE("in space, seen from the other block the force is opposite") {
  Random random(73);
  for (const int max_vertices : {4, 8, 12, 32, 128}) {
    for (int round = 0; round < 100; ++round) {
      const auto [a, b, to_b] = draw_pair(random, max_vertices);
      const PotentialForce<3> on_b = force_between(a, b, to_b), on_a = force_between(b, a, -to_b);
      check_balance(on_b, to_b);
      CHECK((on_b.force + on_a.force).norm() <= 1e-14);
      CHECK((on_b.virial_a - on_a.virial_b).norm() <= 1e-13);
      CHECK((on_b.virial_b - on_a.virial_a).norm() <= 1e-13);
      CHECK(on_b.energy == Approx(on_a.energy).margin(1e-14));
      CHECK(on_b.content == Approx(on_a.content).margin(1e-14));
    }
  }
}

TEST_CASE("in space, a corner or edge that enters or leaves changes the force by no more than it moves") {
  Random random(74);
  for (int round = 0; round < 60; ++round) {
    const auto [a, b, to_b] = draw_pair(random, 12);
    const Vector<3> way = random_vector(random, -1, 1);
    PotentialForce<3> before = force_between(a, b, to_b);
    constexpr int steps = 100;
    for (int i = 1; i <= steps; ++i) {
      const PotentialForce<3> after = force_between(a, b, to_b + double(i) / steps * way);
      CHECK((after.force - before.force).norm() <= most_rate * way.norm() / steps + 1e-14);
      before = after;
    }
  }
}

TEST_CASE("in space, around a closed loop the force does no work") {
  Random random(75);
  for (int round = 0; round < 10; ++round) {
    const PlacedPair pair = draw_pair(random, 12);
    const Vector<3> u = 0.4 * random_direction(random), v = 0.4 * random_direction(random);
    constexpr int steps = 2000;
    const auto place = [&](int i) {
      const double angle = 2 * pi * i / steps;
      return Vector<3>(pair.to_b + std::cos(angle) * u + std::sin(angle) * v);
    };
    double work = 0, exchanged = 0, length = 0;
    for (int i = 0; i < steps; ++i) {
      const Vector<3> way = place(i + 1) - place(i);
      const double done = force_between(pair.a, pair.b, 0.5 * (place(i) + place(i + 1))).force.dot(way);
      work += done;
      exchanged += std::abs(done);
      length += way.norm();
    }
    // By the midpoint rule each step is off by at most a quarter of the rate times its square.
    CHECK(std::abs(work) <= most_rate * length * length / steps / 4);
    if (exchanged > 0) CHECK(std::abs(work) <= 1e-4 * exchanged);
  }
}

TEST_CASE("in space, it does not matter how far the corners of a block are from the contact") {
  // A cube, any way round, over an edge of a plate, whose middle is at the origin.
  Random random(77);
  const Shape<3> near_corners = box_of({8, 8, 2}), far_corners = box_of({1024, 1024, 2});
  for (int round = 0; round < 100; ++round) {
    const Shape<3> cube = block_of(turned(vertices_of(box_of({1, 1, 1})), random_rotation(random)));
    const Vector<3> off = random_vector(random, -0.5, 0.5), from_near(4, 0, 1), from_far(512, 0, 1);
    const PotentialForce<3> found = force_between(far_corners, cube, off + from_far),
                            expected = force_between(near_corners, cube, off + from_near);
    // Rounding of 512, on an area of at most 6, and once more by the arm.
    constexpr double rounding = 6 * 512 * 0x1p-52;
    CHECK((found.force - expected.force).norm() <= rounding);
    CHECK((found.virial_b - expected.virial_b).norm() <= rounding);
    CHECK(std::abs(found.energy - expected.energy) <= rounding);
    CHECK(std::abs(found.content - expected.content) <= rounding);
    check_balance({found.force, found.virial_a / 512, found.virial_b / 512, {}, 0, found.energy / 512},
                  Vector<3>((off + from_far) / 512));
  }
}

TEST_CASE("in space, faces and edges of 1e-9 change the force by no more than their share") {
  constexpr double tiny = 1e-9;
  const Shape<3> cube = box_of({2, 2, 2});
  const auto cut_at = [&](const Vector<3>& point, const Vector<3>& normal) {
    return shape_of(cut_polyhedron(completed(box({2, 2, 2})), point, normal, memory).behind);
  };
  const Shape<3> without_corner = cut_at({1 - tiny, 1, 1}, {1, 1, 1}),
                 without_edge = cut_at({1 - tiny, 0, 1}, {1, 0, 1}),
                 roof =
                     cut_at({0, 0, 1}, {tiny, 0, 1});  // another face, all but in the plane of the upper one
  CHECK(without_corner.face_count() == 7);
  CHECK(without_edge.face_count() == 7);
  CHECK(roof.face_count() == 7);
  for (const Vector<3>& to_b : {Vector<3>(1.9, 1.8, 1.7), Vector<3>(0.3, 0.1, 1.9), Vector<3>(1.9, 0.1, 1.9),
                                Vector<3>(0, 0, 1.9), Vector<3>(1, 1, 1)}) {
    const PotentialForce<3> whole = force_between(cube, cube, to_b);
    for (const Shape<3>* shape : {&without_corner, &without_edge, &roof}) {
      const PotentialForce<3> less = force_between(*shape, cube, to_b),
                              other = force_between(cube, *shape, to_b);
      // No point moves by more than the size, no normal turns by more, and the volume is at most 8.
      for (const PotentialForce<3>* found : {&less, &other}) {
        CHECK((found->force - whole.force).norm() <= 8 * 8 * tiny);
        CHECK(std::abs(found->energy - whole.energy) <= 8 * 8 * tiny);
      }
    }
  }
}

TEST_CASE("in space, faces in one plane with others or with the bisectors between them do no harm") {
  const Shape<3> cube = box_of({2, 2, 2});
  const Shape<3> leaning =
      block_of(turned(vertices_of(box_of({2, 2, std::sqrt(2.0)})), pi / 4, Vector<3>(0, 1, 0)));
  const Vector<3> faces_on_bisectors(0.75, 0, 0.75), flush(0, 0, 1.75), half_flush(0.5, 0, 1.75),
      corner_on_edge(1, 1, 1.75);
  const struct {
    const Shape<3>& b;
    Vector<3> to_b;
  } cases[] = {{leaning, faces_on_bisectors},
               {leaning, {0, 0, 1}},
               {leaning, {1, 0, 1}},
               {cube, flush},
               {cube, half_flush},
               {cube, corner_on_edge},
               {cube, {1, 1, 1}}};
  constexpr double off = 1e-9;
  for (const auto& [b, to_b] : cases) {
    INFO("case " << to_b.transpose());
    const PotentialForce<3> exact = force_between(cube, b, to_b);
    check_balance(exact, to_b);
    for (const Vector<3>& way : {Vector<3>(1, 0, 0), Vector<3>(-1, 0, 0), Vector<3>(0.3, 0.7, 0.2),
                                 Vector<3>(0, -1, 0), Vector<3>(0, 0, 1)}) {
      const PotentialForce<3> near = force_between(cube, b, to_b + off * way);
      // The surface of a cube of side 2 is 24, and nothing moves by more.
      CHECK((near.force - exact.force).norm() <= 24 * off);
      CHECK((near.virial_a - exact.virial_a).norm() <= 8 * 24 * off);
      CHECK((near.virial_b - exact.virial_b).norm() <= 8 * 24 * off);
    }
  }
}

TEST_CASE("in space, scaled by a power of two, forces grow with its cube, to the bit") {
  Random random(76);
  for (int round = 0; round < 50; ++round) {
    const Cloud points_a = random_cloud(random, 12, 1, 1), points_b = random_cloud(random, 12, 1, 1);
    const Vector<3> to_b = random_vector(random, -0.9, 0.9);
    constexpr double f = 0x1p20;
    const PotentialForce<3> small = force_between(block_of(points_a), block_of(points_b), to_b);
    const PotentialForce<3> large =
        force_between(block_of(scaled(points_a, f)), block_of(scaled(points_b, f)), f * to_b);
    CHECK(large.force == f * f * f * small.force);
    CHECK(large.virial_a == f * f * f * f * small.virial_a);
    CHECK(large.virial_b == f * f * f * f * small.virial_b);
    CHECK(large.centroid == f * small.centroid);
    CHECK(large.content == f * f * f * small.content);
    CHECK(large.energy == f * f * f * f * small.energy);
  }
}
