#include <algorithm>
#include <cmath>
#include <numeric>

#include "catch.h"
#include "contacts_3d.h"
#include "force/spring/point_springs.h"
#include "rotations.h"
#include "two_blocks.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Springs of a region in the plane z = 0 with a linear gap.
struct Region {
  Points corners;
  Vector<2> slope{0, 0};

  PointSprings<3> springs() const {
    Contact<3> contact;
    contact.normal = z_axis;
    contact.point_count = int(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      contact.points[i] << corners[i], 0;
      contact.gaps[i] = slope.dot(corners[i]);
    }
    return point_springs({}, {}, {0, 0, 1}, contact);
  }
};

double exterior_angle(const Points& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const Vector<2> in = polygon[i] - polygon[(i + n - 1) % n], out = polygon[(i + 1) % n] - polygon[i];
  return std::acos(std::clamp(in.normalized().dot(out.normalized()), -1.0, 1.0));
}

/// A prism on its lower face on a plate, tilted and pressed in.
struct OnPlate {
  TwoBlocks two;

  OnPlate(const Points& base, bool block_first)
      : two(block_first ? TwoBlocks(block_of(prism(base, 1)), plate())
                        : TwoBlocks(plate(), block_of(prism(base, 1)))),
        block_(block_first ? 0 : 1) {
    two.blocks.place(1 - block_, {0, 0, -1}, Rotation<3>());
    two.meet_at_face_of(1 - block_, z_axis);
  }

  /// The springs by the height of their points over the plate's, where the block's surface is.
  PointSprings<3> springs(const Vector<3>& tilt, double depth) {
    const Rotation<3> rotation = Rotation<3>().turned_by(tilt);
    two.blocks.place(block_, {0, 0, 0}, rotation);
    two.blocks.place(block_, {0, 0, -depth - two.blocks.box(block_).lower.z()}, rotation);
    const Outline<3> a = two.blocks.outline(0), b = two.blocks.outline(1);
    refresh(a, b, two.to_b(), two.pair);
    describe_contact(a, b, two.to_b(), two.pair, two.detect, two.contact);
    return point_springs(a, b, two.to_b(), two.contact);
  }

  double part_of_deepest(const Vector<3>& tilt, double depth) {
    const PointSprings<3> all = springs(tilt, depth);
    const Contact<3>& c = two.contact;
    return all.part[std::min_element(c.gaps, c.gaps + c.point_count) - c.gaps];
  }

 private:
  static Shape<3> plate() { return shape_of(completed(box({20, 20, 2}))); }
  std::int32_t block_;
};

}  // namespace

TEST_CASE("a corner of a region has the part of the stiffness that its exterior angle is of a turn") {
  Random random(81);
  for (int round = 0; round < 300; ++round) {
    const Region region{random_polygon(random, max_region_points / 2, 1)};
    const PointSprings<3> springs = region.springs();
    double sum = 0;
    for (std::size_t i = 0; i < region.corners.size(); ++i) {
      CHECK(springs.part[i] == Approx(exterior_angle(region.corners, i) / (2 * pi)).margin(1e-12));
      sum += springs.part[i];
    }
    CHECK(sum == Approx(1).epsilon(1e-15));
  }
  const PointSprings<3> square = Region{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}.springs();
  for (int i = 0; i < 4; ++i) CHECK(square.part[i] == 0.25);
}

TEST_CASE("corners that split, and regions that become a segment, leave every place its stiffness") {
  Random random(82);
  for (int round = 0; round < 200; ++round) {
    const Region region{random_polygon(random, max_region_points / 2 - 1, 1),
                        {random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)}};
    // A corner is cut off by a little, or is there twice.
    const double little = round % 3 == 0 ? 0 : 1e-9;
    Region split = region;
    const std::size_t n = region.corners.size(), k = std::size_t(random.integer(0, int(n) - 1));
    const Vector<2> corner = region.corners[k];
    const Vector<2> before = region.corners[(k + n - 1) % n], after = region.corners[(k + 1) % n];
    split.corners[k] = corner + little * (after - corner);
    split.corners.insert(split.corners.begin() + std::ptrdiff_t(k), corner + little * (before - corner));
    const PointSprings<3> whole = region.springs(), cut = split.springs();
    CHECK(cut.part[k] + cut.part[k + 1] == Approx(whole.part[k]).margin(1e-6));
    for (std::size_t i = 0; i < n; ++i) {
      if (i != k) CHECK(cut.part[i + (i > k)] == Approx(whole.part[i]).margin(1e-6));
    }
  }
  const double narrow = 1e-9;
  const PointSprings<3> segment = Region{{{0, 0}, {1, 0}, {1, 2 * narrow}, {0, narrow}}}.springs();
  CHECK(segment.part[0] + segment.part[3] == Approx(0.5).margin(1e-8));
  CHECK(segment.part[1] + segment.part[2] == Approx(0.5).margin(1e-8));
}

TEST_CASE("a vertex has the same stiffness however its face is tilted, alone or in a region") {
  Random random(83);
  int of_type[7] = {};
  for (int round = 0; round < 100; ++round) {
    const Points base = random_polygon(random, max_region_points / 2, 0.5);
    OnPlate block(base, round % 2);
    const double direction = random.uniform(0, 2 * pi);
    const Vector<3> axis(std::cos(direction), std::sin(direction), 0);
    double first = 0;
    for (const double tilt : {1e-4, 0.3, 0.9, 1.1, 3.0, 10.0, 30.0}) {
      const double part = block.part_of_deepest(tilt * block.two.detect.parallel_angle * axis, 1e-5);
      ++of_type[int(block.two.contact.type)];
      if (first == 0) first = part;
      CHECK(part == Approx(first).epsilon(1e-9));
    }
  }
  CHECK(of_type[int(ContactType::face_face)] > 200);
  CHECK(of_type[int(ContactType::vertex_face)] > 200);
}

TEST_CASE("an edge has the same stiffness however the face at it is tilted") {
  Random random(84);
  for (int round = 0; round < 100; ++round) {
    const Points base = random_polygon(random, max_region_points / 2, 0.5);
    OnPlate block(base, round % 2);
    const Vector<2> edge = (base[1] - base[0]).normalized();
    const Vector<3> axis(edge.x(), edge.y(), 0);
    for (const double tilt : {0.5, 1.5, 4.0, 7.0, 40.0}) {
      constexpr double depth = 1e-8;  // that no other corner reaches
      const PointSprings<3> springs = block.springs(tilt * block.two.detect.parallel_angle * axis, depth);
      const Contact<3>& c = block.two.contact;
      double sum = 0;
      for (int i = 0; i < c.point_count; ++i) sum += c.gaps[i] < -0.5 * depth ? springs.part[i] : 0;
      CHECK(sum == Approx((exterior_angle(base, 0) + exterior_angle(base, 1)) / (2 * pi)).epsilon(1e-9));
    }
  }
}
