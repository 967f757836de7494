#include <cmath>

#include "catch.h"
#include "force/spring/joint_face.h"
#include "rotations.h"
#include "two_blocks.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 1000;
const Vector<3> brick_size(1, 2, 1);
constexpr double area = 2;

/// A brick on a plate, of which it was a part: bonded by so much per area.
TwoBlocks bonded_brick() {
  TwoBlocks two(shape_of(completed(box({20, 20, 2}))), shape_of(completed(box(brick_size))));
  two.meet_at_face_of(0, z_axis);
  two.bonded = true;
  two.law.stiffness_kind = StiffnessKind::per_area;
  two.law.normal_stiffness = stiffness;
  two.law.shear_stiffness = 0.4 * stiffness;
  two.law.tan_friction = 0.5;
  two.law.cohesion = 1e6;
  two.law.tensile_strength = 1e6;
  return two;
}

/// With its lower face's centre so far above the plate, turned about that centre.
void lift(TwoBlocks& two, double gap, const Vector<3>& tilt) {
  const Rotation<3> turn = Rotation<3>().turned_by(tilt);
  two.blocks.place(1, Vector<3>(0.5, -0.25, 1 + gap) + turn * Vector<3>(0, 0, 0.5), turn);
}

}  // namespace

TEST_CASE("a bonded face pulls by area times stiffness times gap, and bends by its second moments") {
  TwoBlocks two = bonded_brick();
  for (const double gap : {-0.01, 0.0, 0.01}) {
    for (const Vector<3>& tilt :
         {Vector<3>(0.002, 0, 0), Vector<3>(0, -0.003, 0), Vector<3>(0.001, 0.002, 0)}) {
      lift(two, gap, tilt);
      const PairLoad<3> load = two.evaluate();
      REQUIRE(two.contact.type == ContactType::face_face);
      // Of a rectangle, A y^2 / 12 and A x^2 / 12. Seen along the normal the face is smaller by the tilt's
      // square, and its slope greater.
      const double about_x = area * 4 / 12, about_y = area * 1 / 12, square = tilt.squaredNorm();
      const double scale = stiffness * area;
      CHECK(normal_force(load) == Approx(-scale * gap).epsilon(2 * square).margin(scale * 1e-15));
      CHECK((load.contact.point - Vector<3>(0.5, -0.25, 1)).norm() < std::abs(gap) * tilt.norm() + 1e-14);
      const Vector<3> expected = -stiffness * Vector<3>(about_x * tilt.x(), about_y * tilt.y(), 0);
      CHECK((load.contact.couple - expected).norm() < 4 * square * expected.norm());
      const double bending = about_x * tilt.x() * tilt.x() + about_y * tilt.y() * tilt.y();
      CHECK(two.energy.strain == Approx(0.5 * stiffness * (area * gap * gap + bending)).epsilon(4 * square));
    }
  }
}

TEST_CASE("integrals over a bonded face are those over many small pieces of it") {
  Random random(71);
  for (int round = 0; round < 20; ++round) {
    // A polygon of up to 8 corners with a linear gap.
    const Points polygon = random_polygon(random, max_region_points / 2, 1);
    const Shape<2> shape = shape_of(polygon);
    const double at_origin = random.uniform(-1, 1);
    const Vector<2> slope(random.uniform(-1, 1), random.uniform(-1, 1));
    const auto gap_at = [&](const Vector<2>& p) { return at_origin + slope.dot(p); };
    const Outline<2> outline = shape.outline();
    Contact<3> contact;
    contact.type = ContactType::face_face;
    contact.normal = z_axis;
    contact.area = shape.area();
    contact.point_count = outline.count;
    const Vector<2> center = shape.centroid();
    contact.center << center, 0;
    contact.center_gap = gap_at(center);
    for (int i = 0; i < outline.count; ++i) {
      const Vector<2> p = outline.vertex(i) + center;
      contact.points[i] << p, 0;
      contact.gaps[i] = gap_at(p);
    }
    const JointFace<3> face = joint_face(contact);

    // Midpoints of a grid. What a cell on the border is wrong by has the area of the cell.
    constexpr int cells = 400;
    const double width = 2.0 / cells, piece = width * width;
    double force = 0, squared = 0, polar = 0;
    Vector<2> tilted(0, 0);
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const Vector<2> p(-1 + (i + 0.5) * width, -1 + (j + 0.5) * width);
        bool inside = true;
        for (int e = 0; e < outline.count; ++e)
          inside = inside && outline.normal(e).dot(p - center) <= outline.offset[e];
        if (!inside) continue;
        const double gap = gap_at(p);
        force -= piece * gap;
        squared += piece * gap * gap;
        tilted -= piece * gap * (p - center);
        polar += piece * (p - center).squaredNorm();
      }
    }
    const double margin = 8.0 * width * 3;  // border, times the largest integrand
    CHECK(face.base == contact.area);
    CHECK(face.force == Approx(force).margin(margin));
    CHECK(face.depth_squared == Approx(squared).margin(3 * margin));
    CHECK((face.couple - cross_product({tilted.x(), tilted.y(), 0}, z_axis)).norm() < margin);
    CHECK(face.spread.trace() * face.base == Approx(polar).margin(margin));
    CHECK(face.center == contact.center);
  }
}

TEST_CASE("a bonded face pulls down the slope of its energy") {
  // As it turns, the face is seen smaller and its middle moves: by the tilt times the gap, and these times
  // the stiffness, the area and the gap are left out.
  Random random(72);
  for (int round = 0; round < 40; ++round) {
    TwoBlocks two = bonded_brick();
    const Vector<3> tilt(random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004), random.uniform(-1, 1));
    lift(two, random.uniform(-0.01, 0.01), tilt);
    const Vector<3> position = two.blocks.position[1];
    const Rotation<3> rotation = two.blocks.rotation[1];
    const PairLoad<3> load = two.evaluate();
    const auto strain_at = [&](const Vector<3>& p, const Rotation<3>& r) {
      two.blocks.place(1, p, r);
      two.shear = {};
      two.evaluate();
      return two.energy.strain;
    };
    const double way = 1e-6, scale = stiffness * area * 0.02;
    for (int k = 0; k < 3; ++k) {
      const Vector<3> along = way * Vector<3>::Unit(k);
      const double force = -(strain_at(position + along, rotation) - strain_at(position - along, rotation));
      const double torque =
          -(strain_at(position, rotation.turned_by(along)) - strain_at(position, rotation.turned_by(-along)));
      CHECK(load.contact.force[k] == Approx(force / (2 * way)).margin(1e-7 * scale));
      CHECK(load.contact.torque_on_b(two.to_b())[k] ==
            Approx(torque / (2 * way)).margin(scale * 0.006 * 0.02 + 1e-7 * scale));
    }
  }
}

TEST_CASE("a bond torn in tension books what it held, and pulls no more") {
  for (const bool tilted : {false, true}) {
    TwoBlocks two = bonded_brick();
    two.law.tensile_strength = 5;
    const Vector<3> tilt = tilted ? Vector<3>(0.004, 0.002, 0) : Vector<3>(0, 0, 0);
    lift(two, 0.0049, tilt);
    CHECK(normal_force(two.evaluate()) == Approx(-stiffness * area * 0.0049).epsilon(1e-4));
    CHECK(two.bonded);
    CHECK(two.energy.friction_loss == 0);
    const double gap = 0.0051;
    lift(two, gap, tilt);
    const PairLoad<3> load = two.evaluate();
    CHECK_FALSE(two.bonded);
    const double held =
        0.5 * stiffness * (area * gap * gap + area / 12 * (4 * tilt.x() * tilt.x() + tilt.y() * tilt.y()));
    CHECK(two.energy.strain + two.energy.friction_loss == Approx(held).epsilon(1e-4));
    // A tilt of 0.004 leaves a corner in the plate only when its edge, 1 away, is lower than the gap.
    CHECK(normal_force(load) >= 0);
    if (!tilted) CHECK(load.contact.force == Vector<3>(0, 0, 0));
  }
}

TEST_CASE("a bond broken by shear books what it held, also what it held in tension") {
  for (const StiffnessKind kind : {StiffnessKind::per_contact, StiffnessKind::per_area}) {
    for (const double gap : {0.003, -0.003}) {
      TwoBlocks two = bonded_brick();
      two.law.stiffness_kind = kind;
      two.law.cohesion = 0.1;
      const double base = kind == StiffnessKind::per_area ? area : 1;
      const double pressed = std::max(-gap, 0.0) * stiffness * base;
      const double k = two.law.shear_stiffness * base, cohesion = 0.1 * area;
      lift(two, gap, {0, 0, 0});
      two.evaluate();
      const double normal_strain = 0.5 * stiffness * base * gap * gap;
      CHECK(two.energy.strain == Approx(normal_strain));

      // Just below the limit, and just above.
      const double limit = pressed * two.law.tan_friction + cohesion;
      const auto slip_by = [&](double way) {
        two.blocks.set_motion(1, {way, 0, 0}, {0, 0, 0});
        return two.evaluate(1);
      };
      CHECK(slip_by(0.99 * limit / k).contact.force.x() == Approx(-0.99 * limit));
      CHECK(two.bonded);
      CHECK(two.energy.friction_loss == Approx(0).margin(1e-12));
      const double strain_before = two.energy.strain;

      const PairLoad<3> broken = slip_by(0.02 * limit / k);
      CHECK_FALSE(two.bonded);
      const double friction = pressed * two.law.tan_friction;
      CHECK(broken.contact.force.x() == Approx(-friction).margin(1e-12));
      CHECK(normal_force(broken) == Approx(pressed).margin(1e-12));
      // Nothing is lost sight of: what the motion puts in, the mean force times the way, is held or booked.
      const double put_in = 0.5 * (0.99 * limit + friction) * 0.02 * limit / k;
      CHECK(two.energy.strain + two.energy.friction_loss == Approx(strain_before + put_in));
      const double strain_after = two.energy.strain;
      slip_by(0);
      CHECK(two.energy.strain == Approx(strain_after).margin(1e-12));
    }
  }
}
