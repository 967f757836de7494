#include "narrow_phase/time_of_impact.h"

#include <cmath>

#include "catch.h"
#include "geometry/deformed_outline.h"
#include "narrow_phase/pair.h"
#include "polygons.h"
#include "polyhedra.h"

namespace halfspace::test {
namespace {

template <int D>
Impact<D> impact_of(const Shape<D>& a, const Sweep<D>& sweep_of_a, const Shape<D>& b,
                    const Sweep<D>& sweep_of_b) {
  std::vector<double> room(component_count(a.outline()) + component_count(b.outline()));
  return time_of_impact(a.outline(), sweep_of_a, b.outline(), sweep_of_b, room.data());
}

/// The library's verdict at a time.
template <int D>
bool touch_at(double time, const Shape<D>& a, const Sweep<D>& sweep_of_a, const Shape<D>& b,
              const Sweep<D>& sweep_of_b) {
  std::vector<double> of_a(component_count(a.outline())), of_b(component_count(b.outline()));
  const Vector<D> to_b =
      (sweep_of_b.position - sweep_of_a.position) + time * (sweep_of_b.way - sweep_of_a.way);
  return find_separation(deformed(a.outline(), sweep_of_a.gradient_at(time), of_a.data()),
                         deformed(b.outline(), sweep_of_b.gradient_at(time), of_b.data()), to_b)
             .gap <= 0;
}

/// Apart at all sampled times before the impact, or throughout.
template <int D>
void check_never_late(const Shape<D>& a, const Sweep<D>& sweep_of_a, const Shape<D>& b,
                      const Sweep<D>& sweep_of_b) {
  const Impact<D> impact = impact_of(a, sweep_of_a, b, sweep_of_b);
  CHECK((impact.state == Impact<D>::touching_at_start) == touch_at(0, a, sweep_of_a, b, sweep_of_b));
  if (impact.state == Impact<D>::touching_at_start) return;
  if (impact.state == Impact<D>::touches) CHECK(impact.gap <= 1e-11);
  constexpr int samples = 100;
  int missed = 0;
  for (int i = 0; i < samples; ++i) {
    missed += touch_at(impact.time * i / samples, a, sweep_of_a, b, sweep_of_b);
  }
  CHECK(missed == 0);
}

}  // namespace

TEST_CASE("A bar that crosses a plate within an interval touches it when its end is there") {
  const Shape<2> bar = shape_of(rectangle(0.005, 0.1)), plate = shape_of(rectangle(1, 0.005));
  Sweep<2> still, falling;
  falling.position = {0, 1};
  falling.way = {0, -3};
  const Impact<2> impact = impact_of(plate, still, bar, falling);
  REQUIRE(impact.state == Impact<2>::touches);
  CHECK(impact.time == Approx((1 - 0.05 - 0.0025) / 3).epsilon(1e-11));
  CHECK(impact.time <= (1 - 0.05 - 0.0025) / 3);
  CHECK(impact.normal.y() == 1);
  CHECK(impact.pair.owner == 0);
}

TEST_CASE("A needle that turns strikes with its tip") {
  const double length = 2, width = 1e-3;
  const Shape<2> needle = shape_of(rectangle(length, width)), post = shape_of(rectangle(0.1, 0.1));
  Sweep<2> turning, still;
  turning.turn[0] = 20;  // some three turns
  still.position = {0, 0.9};
  const Impact<2> impact = impact_of(needle, turning, post, still);
  REQUIRE(impact.state == Impact<2>::touches);
  // The long side comes round to a lower corner of the post.
  const double angle = std::atan2(0.85, 0.05) - std::asin(0.5 * width / std::hypot(0.85, 0.05));
  CHECK(impact.time == Approx(angle / 20).epsilon(1e-10));
  CHECK(impact.time <= angle / 20 * (1 + 1e-15));

  still.position = {0, 1.06};
  CHECK(impact_of(needle, turning, post, still).state == Impact<2>::never);
}

TEST_CASE("Faces that slide along each other, apart by whatever little, never touch") {
  const Shape<2> square = shape_of(rectangle(1, 1));
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  for (const double gap : {1e-3, 1e-9, 1e-12}) {
    Sweep<2> still, sliding;
    sliding.position = {-1, 1 + gap};
    sliding.way = {2, 0};
    CHECK(impact_of(square, still, square, sliding).state == Impact<2>::never);
    Sweep<3> still_3, sliding_3;
    sliding_3.position = {-1, 0, 1 + gap};
    sliding_3.way = {2, 0.25, 0};
    CHECK(impact_of(cube, still_3, cube, sliding_3).state == Impact<3>::never);
    sliding_3.way = {0, 0, 1e-3};  // away
    sliding_3.turn = {0, 0, 7};
    CHECK(impact_of(cube, still_3, cube, sliding_3).state == Impact<3>::never);
  }
}

TEST_CASE("Blocks in contact are touching at the start, also where they part") {
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  Sweep<3> still, parting;
  parting.position = {0, 0, 1};
  parting.way = {0, 0, 1};
  const Impact<3> impact = impact_of(cube, still, cube, parting);
  CHECK(impact.state == Impact<3>::touching_at_start);
  CHECK(impact.time == 0);
  CHECK(impact.gap == 0);
}

TEST_CASE("A block that is stretched reaches another") {
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  Sweep<3> stretched, still;
  stretched.stretch(2, 2) = 1;
  still.position = {0.25, 0, 1.25};
  const Impact<3> impact = impact_of(cube, stretched, cube, still);
  REQUIRE(impact.state == Impact<3>::touches);
  CHECK(impact.time == Approx(0.5).epsilon(1e-11));
  CHECK(impact.time <= 0.5);
}

TEST_CASE("No touch of random polygons is told late, and none early") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const double turn = i % 2 ? 0.3 : 10, thin = i % 3 ? 1 : 1e-3;
    const auto shape = [&] {
      Points points = random_polygon(random, 8, 1);
      for (Vector<2>& point : points) point.y() *= thin;
      return shape_of(points);
    };
    const Shape<2> a = shape(), b = shape();
    const auto sweep = [&](const Vector<2>& position) {
      Sweep<2> sweep;
      sweep.position = position;
      sweep.way = -0.5 * position + Vector<2>(random.uniform(-1, 1), random.uniform(-1, 1));
      sweep.gradient = Rotation<2>::from_angle(random.uniform(-3, 3)).tensor();
      sweep.turn[0] = random.uniform(-turn, turn);
      if (i % 5 == 0) sweep.stretch << 0.1, random.uniform(-0.2, 0.2), 0, random.uniform(-0.2, 0.2);
      return sweep;
    };
    check_never_late(a, sweep({0, 0}), b, sweep({random.uniform(1, 3), random.uniform(-1, 1)}));
  }
}

TEST_CASE("No touch of random polyhedra is told late, and none early") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double turn = i % 2 ? 0.3 : 10, thin = i % 3 ? 1 : 1e-3;
    const int vertices = i % 4 ? 8 : 40;
    const auto shape = [&] {
      Cloud points;
      for (int k = 0; k < vertices; ++k)
        points.push_back(random_direction(random).cwiseProduct(Vector<3>(1, thin, thin)));
      return shape_of(hull_of(points));
    };
    const Shape<3> a = shape(), b = shape();
    const auto sweep = [&](const Vector<3>& position) {
      Sweep<3> sweep;
      sweep.position = position;
      sweep.way = -0.5 * position + random_vector(random, -1, 1);
      sweep.gradient = random_rotation(random);
      sweep.turn = random.uniform(0, turn) * random_direction(random);
      if (i % 5 == 0) sweep.stretch.diagonal() = random_vector(random, -0.2, 0.2);
      return sweep;
    };
    check_never_late(a, sweep({0, 0, 0}), b, sweep(random.uniform(1, 3) * random_direction(random)));
  }
}

}  // namespace halfspace::test
