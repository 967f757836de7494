#include "geometry/mean_distance.h"

#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "force/spring/point_springs.h"
#include "rectangle.h"
#include "two_blocks.h"

using namespace halfspace;
using namespace halfspace::test;

TEST_CASE("the mean distance of an ellipse is exact for a disc, and near for rectangles") {
  const double square = 9.0 / 4;  // of a disc's points, along either axis, for a radius of 3
  CHECK(mean_distance(2 * square, square * square) == Approx(2));
  for (const double b : {1.0, 0.7, 0.3, 0.1, 0.01}) {
    const double x = 1.0 / 12, y = b * b / 12;
    CHECK(mean_distance(x + y, x * y) ==
          Approx(halfspace_test::mean_distance_of_rectangle(1, b)).epsilon(0.03));
  }
  CHECK(mean_distance(0, 0) == 0);
}

TEST_CASE("the part of a face that overlaps has the middle and the mean distance of what is left of it") {
  // A brick of 1 x 2 on a plate, tilted so that this part of its length overlaps.
  const Vector<3> size(1, 2, 1);
  const double tilt = 1e-3, length = GENERATE(2.0, 1.5, 1.0, 0.25);
  TwoBlocks two(shape_of(completed(box({20, 20, 2}))), shape_of(completed(box(size))));
  two.blocks.place(1, Vector<3>::Zero(), Rotation<3>().turned_by(tilt * x_axis));
  const double low = two.blocks.box(1).lower.z(), depth = length * std::sin(tilt);
  two.blocks.place(1, {0, 0, 1 - depth - low}, Rotation<3>().turned_by(tilt * x_axis));
  two.meet_at_face_of(0, z_axis);
  two.evaluate();
  REQUIRE(two.contact.type == ContactType::face_face);
  const LoadedPart part = loaded_part(two.contact, false);
  CHECK(part.middle.x() == Approx(0).margin(1e-9));
  CHECK(part.middle.y() == Approx(-1 + length / 2).margin(2e-3));
  CHECK(part.mean_distance ==
        Approx(mean_distance((1 + length * length) / 12, length * length / 144)).epsilon(1e-5));
}

TEST_CASE("the part of a face that overlaps is the same from either side") {
  Contact<3> contact;
  contact.point_count = 4;
  const Vector<3> corners[] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const Rotation<3> turn = Rotation<3>().turned_by(GENERATE(0.0, 0.8, 1.6, 2.4, 3.2) * Vector<3>(1, 0.3, 0));
  for (const bool is_flipped : {false, true}) {
    for (int i = 0; i < 4; ++i) {
      const Vector<3>& corner = corners[is_flipped ? 3 - i : i];
      contact.points[i] = turn * corner;
      contact.gaps[i] = 0.1 * corner.x() - 0.05;
    }
    contact.normal = turn * Vector<3>(0, 0, is_flipped ? -1 : 1);
    contact.center = Vector<3>::Zero();
    const LoadedPart part = loaded_part(contact, false);
    CHECK((part.middle - turn * Vector<3>(-0.25, 0, 0)).norm() < 1e-12);
    CHECK(part.mean_distance == Approx(mean_distance(1.5 * 1.5 / 12 + 4.0 / 12, 1.5 * 1.5 * 4 / 144)));
  }
}

TEST_CASE("the part of an edge that overlaps ends where its gap is 0, whichever end is deep") {
  Contact<3> contact;
  contact.point_count = 2;
  contact.points[0] = {0, 0, 0};
  contact.points[1] = {4, 0, 0};
  contact.center = {2, 0, 0};
  const struct {
    double gaps[2], middle, mean_distance;
  } cases[] = {{{-1, 3}, 0.5, 0.25}, {{3, -1}, 3.5, 0.25}, {{-1, -2}, 2, 1}, {{1, 2}, 2, 1}, {{0, -1}, 2, 1}};
  for (const auto& c : cases) {
    std::copy_n(c.gaps, 2, contact.gaps);
    const LoadedPart part = loaded_part(contact, false);
    CHECK(part.middle.x() == Approx(c.middle));
    CHECK(part.mean_distance == Approx(c.mean_distance));
    CHECK(loaded_part(contact, true).middle.x() == Approx(2));
  }
}
