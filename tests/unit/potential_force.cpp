#include "force/potential/potential_force.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "geometry/polygon/cut.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

PotentialForce<2> force_between(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b) {
  PotentialRoom<2> room(std::pmr::get_default_resource());
  return potential_force(a.outline(), b.outline(), to_b, room);
}

Points placed(const Outline<2>& outline, const Vector<2>& at) {
  Points points;
  for (int i = 0; i < outline.count; ++i) points.push_back(outline.vertex(i) + at);
  return points;
}

/// The paper's procedure for one of the two potentials, but that every crossing of two edges' depths is taken
/// for a demarcation point: needless ones do no harm. Force and moment on the block whose potential it is.
Vector<3> paper_integral(const Points& owner, const Points& intersection) {
  struct HalfPlane {
    Vector<2> normal;
    double offset;
  };
  std::vector<HalfPlane> edges;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const Vector<2> along = owner[(i + 1) % owner.size()] - owner[i];
    const Vector<2> normal = -perpendicular(along) / along.norm();
    edges.push_back({normal, normal.dot(owner[i])});
  }
  const auto potential = [&](const Vector<2>& p) {
    double least = HUGE_VAL;
    for (const HalfPlane& e : edges) least = std::min(least, e.offset - e.normal.dot(p));
    return std::max(least, 0.0);
  };
  Vector<3> sum = Vector<3>::Zero();
  for (std::size_t i = 0; i < intersection.size(); ++i) {
    const Vector<2> from = intersection[i], to = intersection[(i + 1) % intersection.size()];
    const Vector<2> outward = -perpendicular(Vector<2>(to - from));  // as long as the edge
    std::vector<double> demarcations = {0, 1};
    for (const HalfPlane& e : edges) {
      for (const HalfPlane& f : edges) {
        const Vector<2> jump = e.normal - f.normal;
        const double share = (e.offset - f.offset - jump.dot(from)) / jump.dot(to - from);
        if (share > 0 && share < 1) demarcations.push_back(share);
      }
    }
    std::sort(demarcations.begin(), demarcations.end());
    for (std::size_t k = 1; k < demarcations.size(); ++k) {
      const double s = demarcations[k - 1], t = demarcations[k];
      const Vector<2> a = from + s * (to - from), b = from + t * (to - from);
      const double f_a = potential(a), f_b = potential(b);
      if (f_a + f_b == 0) continue;
      const Vector<2> force = (t - s) / 2 * (f_a + f_b) * outward;
      const Vector<2> point = a + (f_a + 2 * f_b) / (3 * (f_a + f_b)) * (b - a);
      sum += Vector<3>(force.x(), force.y(), cross(point, force));
    }
  }
  return sum;
}

struct Pair {
  Shape<2> a, b;
  Vector<2> to_b;
};

/// From just touching to one inside the other.
Pair draw_pair(Random& random) {
  const double angle = random.uniform(0, 7), distance = random.uniform(0, 1.9);
  return {shape_of(random_polygon(random, 12, 1)),
          shape_of(random_polygon(random, 12, random.uniform(0.2, 1))),
          {distance * std::cos(angle), distance * std::sin(angle)}};
}

}  // namespace

TEST_CASE("aligned faces push with 2 (d b - d^2), and have stored d^2 b - 2/3 d^3") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  for (const double depth : {1e-6, 0.01, 0.25, 0.9}) {
    const PotentialForce<2> found = force_between(square, square, {0, 2 - depth});
    CHECK(found.force.y() == Approx(2 * (2 * depth - depth * depth)).epsilon(1e-9));
    CHECK(std::abs(found.force.x()) <= 1e-15);
    CHECK(std::abs(moment(found.virial_a)[0]) <= 1e-15);
    CHECK(found.content == Approx(2 * depth).epsilon(1e-9));
    CHECK((found.centroid - Vector<2>(0, 1 - depth / 2)).norm() <= 1e-15);
    CHECK(found.energy == Approx(2 * depth * depth - 2 * depth * depth * depth / 3).epsilon(1e-9));
  }
}

TEST_CASE("force, moment and energy of separated blocks are 0") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  for (const Vector<2>& to_b : {Vector<2>(0, 2.5), Vector<2>(-2.1, 0.3), Vector<2>(2.01, 2.01)}) {
    const PotentialForce<2> found = force_between(square, square, to_b);
    CHECK(found.force.isZero(0));
    CHECK(found.virial_a.isZero(0));
    CHECK(found.virial_b.isZero(0));
    CHECK(found.content == 0);
    CHECK(found.energy == 0);
  }
}

TEST_CASE("force and moment are those of the paper's integral over the outline of the intersection") {
  Random random(61);
  int overlapping = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto [a, b, to_b] = draw_pair(random);
    const Points of_a = placed(a.outline(), {0, 0}), of_b = placed(b.outline(), to_b);
    Points intersection = of_b;
    for (int edge = 0; edge < a.outline().count && !intersection.empty(); ++edge) {
      const auto parts = cut_polygon(intersection, a.outline().vertex(edge), a.outline().normal(edge),
                                     std::pmr::get_default_resource());
      intersection.assign(parts.behind.begin(), parts.behind.end());
    }
    const PotentialForce<2> found = force_between(a, b, to_b);
    // On a, from both potentials.
    Vector<3> expected = Vector<3>::Zero();
    if (!intersection.empty()) {
      expected = paper_integral(of_a, intersection) - paper_integral(of_b, intersection);
      ++overlapping;
    }
    // Forces are at most of the order of the blocks' area; both ways sum some dozens of products of numbers
    // around 1.
    CHECK(std::abs(found.force.x() + expected.x()) <= 1e-13);
    CHECK(std::abs(found.force.y() + expected.y()) <= 1e-13);
    CHECK(std::abs(moment(found.virial_a)[0] - expected.z()) <= 1e-13);
  }
  CHECK(overlapping > 1000);
}

TEST_CASE("force and moment are the gradient of the energy") {
  Random random(62);
  constexpr double step = 1e-4;
  for (int round = 0; round < 300; ++round) {
    const Pair pair = draw_pair(random);
    const Shape<2>&a = pair.a, &b = pair.b;
    const Vector<2>& to_b = pair.to_b;
    const PotentialForce<2> found = force_between(a, b, to_b);
    const auto energy_at = [&](double x, double y, double turn) {
      // All of b turns about the centroid of a.
      const Eigen::Rotation2D<double> rotation(turn);
      Points turned;
      for (const Vector<2>& p : placed(b.outline(), to_b + Vector<2>(x, y))) turned.push_back(rotation * p);
      const Shape<2> moved = shape_of(turned);
      return force_between(a, moved, rotation * Vector<2>(to_b + Vector<2>(x, y))).energy;
    };
    const auto slope = [&](double x, double y, double turn) {
      const double h = step;
      return (energy_at(h * x, h * y, h * turn) - energy_at(-h * x, -h * y, -h * turn)) / (2 * h);
    };
    // The force has a bounded second derivative but where a corner enters, passes a ridge or leaves; there
    // its first one jumps by at most the length of the outline, that is by some 10.
    CHECK(std::abs(slope(1, 0, 0) + found.force.x()) <= 10 * step);
    CHECK(std::abs(slope(0, 1, 0) + found.force.y()) <= 10 * step);
    CHECK(std::abs(slope(0, 0, 1) - moment(found.virial_a)[0]) <= 20 * step);
  }
}

TEST_CASE("force and virials are the gradient of the energy as either block is strained and turned") {
  Random random(66);
  constexpr double step = 1e-4;
  for (int round = 0; round < 300; ++round) {
    const Pair pair = draw_pair(random);
    const Tensor<2> rate_a = random_tensor<2>(random), rate_b = random_tensor<2>(random);
    const auto energy_after = [&](double time) {
      const auto strained = [&](const Shape<2>& shape, const Tensor<2>& rate) {
        Points points;
        for (const Vector<2>& p : placed(shape.outline(), {0, 0})) points.push_back(p + time * rate * p);
        return shape_of(points);
      };
      return force_between(strained(pair.a, rate_a), strained(pair.b, rate_b), pair.to_b).energy;
    };
    const PotentialForce<2> found = force_between(pair.a, pair.b, pair.to_b);
    const double power =
        found.virial_a.cwiseProduct(rate_a).sum() + found.virial_b.cwiseProduct(rate_b).sum();
    // As above, of points that move by up to 2.
    CHECK(std::abs((energy_after(step) - energy_after(-step)) / (2 * step) + power) <= 40 * step);
  }
}

TEST_CASE("seen from the other block the force is opposite") {
  // What the blocks share has an outline of at most 2 pi and corners at coordinates below 4, off by half a
  // unit in their last place: the areas of either potential's cells change by no more than the product.
  constexpr double rounding = 2 * 2 * std::numbers::pi * 0x1p-52;
  Random random(63);
  for (int round = 0; round < 1000; ++round) {
    const auto [a, b, to_b] = draw_pair(random);
    const PotentialForce<2> on_b = force_between(a, b, to_b), on_a = force_between(b, a, -to_b);
    CHECK((on_b.force + on_a.force).norm() <= rounding);
    CHECK((on_b.virial_a - on_a.virial_b).norm() <= 1e-14);
    CHECK((on_b.virial_b - on_a.virial_a).norm() <= 1e-14);
    CHECK(std::abs((moment(on_b.virial_a) + moment(on_b.virial_b))[0] + cross(to_b, on_b.force)) <= 1e-14);
    CHECK(on_b.energy == Approx(on_a.energy).margin(1e-15));
  }
}

TEST_CASE("a corner that enters, or leaves, changes the force by no more than it moves") {
  Random random(64);
  for (int round = 0; round < 200; ++round) {
    const auto [a, b, to_b] = draw_pair(random);
    const Vector<2> way(random.uniform(-1, 1), random.uniform(-1, 1));
    PotentialForce<2> before = force_between(a, b, to_b);
    constexpr int steps = 200;
    for (int i = 1; i <= steps; ++i) {
      const PotentialForce<2> after = force_between(a, b, to_b + double(i) / steps * way);
      // Each cell gains or loses at most its outline times the way; all outlines together are below 2 * 2
      // * 7.
      CHECK((after.force - before.force).norm() <= 28 * way.norm() / steps);
      before = after;
    }
  }
}

TEST_CASE("a corner cut off by 1e-9 changes the force by its share") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  constexpr double tiny = 1e-9;
  const Shape<2> cut = shape_of({{-1, -1}, {1, -1}, {1, 1 - tiny}, {1 - tiny, 1}, {-1, 1}});
  for (const Vector<2>& to_b : {Vector<2>(1.9, 1.8), Vector<2>(0.3, 1.9), Vector<2>(1, 1)}) {
    const PotentialForce<2> whole = force_between(square, square, to_b),
                            less = force_between(cut, square, to_b);
    CHECK((whole.force - less.force).norm() <= 10 * tiny);
    CHECK(std::abs(whole.energy - less.energy) <= 10 * tiny);
  }
}

// Rounding gives edges that all but go straight on one and the same half-plane.
TEST_CASE("an edge in two that nothing tells apart pushes as one does") {
  const double x[] = {-1, 1, 1, 1, -1, -1}, y[] = {-1, -1, 0, 1, 1, 1};
  const double nx[] = {0, 1, 1, 0, -1, -1}, ny[] = {-1, 0, 0, 1, 0, 0}, offset[] = {1, 1, 1, 1, 1, 1};
  const Outline<2> divided{5, x, y, nx, ny, offset};
  const Shape<2> whole = shape_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
                 other = shape_of({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  PotentialRoom<2> room(std::pmr::get_default_resource());
  const Vector<2> over_the_top{1, 1.4};  // so that the top is nearest first
  const PotentialForce<2> found = potential_force(divided, other.outline(), over_the_top, room),
                          expected = potential_force(whole.outline(), other.outline(), over_the_top, room);
  CHECK(found.force == expected.force);
  CHECK(found.virial_a == expected.virial_a);
  CHECK(found.energy == expected.energy);
}

TEST_CASE("scaled by a power of two, forces grow with its square, to the bit") {
  Random random(65);
  for (int round = 0; round < 200; ++round) {
    const Points points_a = random_polygon(random, 12, 1), points_b = random_polygon(random, 12, 1);
    const auto scaled = [](Points points) {
      for (Vector<2>& p : points) p *= 8;
      return shape_of(points);
    };
    const Vector<2> to_b(random.uniform(-1, 1), random.uniform(-1, 1));
    const PotentialForce<2> small = force_between(shape_of(points_a), shape_of(points_b), to_b);
    const PotentialForce<2> large = force_between(scaled(points_a), scaled(points_b), 8 * to_b);
    CHECK(large.force == 64 * small.force);
    CHECK(large.virial_a == 512 * small.virial_a);
    CHECK(large.virial_b == 512 * small.virial_b);
    CHECK(large.energy == 512 * small.energy);
  }
}
