// hs_pair_time_of_impact(): when, where and how, in 2D and 3D, and what it refuses.

#include <cmath>
#include <cstring>

#include "capi/handles.h"
#include "capi/polyhedra.h"
#include "capi/refusals.h"
#include "catch.h"

namespace halfspace_test {
namespace {

hs_motion_def motion(double x, double y, double vx, double vy, double spin = 0) {
  hs_motion_def def;
  if (hs_motion_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no motion");
  def.start.position[0] = x;
  def.start.position[1] = y;
  def.velocity[0] = vx;
  def.velocity[1] = vy;
  def.angular_velocity[2] = spin;
  return def;
}

hs_impact impact_of(const Shape& a, const hs_motion_def& motion_a, const Shape& b,
                    const hs_motion_def& motion_b, double duration, const Context& context) {
  hs_impact impact;
  require_ok(hs_pair_time_of_impact(a.get(), &motion_a, b.get(), &motion_b, duration, &impact),
             context.get());
  return impact;
}

}  // namespace

TEST_CASE("A bar that crosses a plate between two looks is told, with time, place and features") {
  const Context context = make_context();
  const Shape plate = make_shape(context.get(), box(-0.5, -0.0025, 0.5, 0.0025));
  const Shape bar = make_shape(context.get(), box(-0.0025, -0.05, 0.0025, 0.05));
  // From far away: what both share costs no digits.
  for (const double far : {0.0, 0x1p20}) {
    const hs_impact impact =
        impact_of(plate, motion(far, 0, 7, 0), bar, motion(far + 0.25, 1, 7, -300), 0.01, context);
    const double expected = (1 - 0.0525) / 300;
    CHECK(impact.state == HS_IMPACT_TOUCH);
    CHECK(impact.time == Approx(expected).epsilon(1e-11));
    CHECK(impact.time <= expected * (1 + 1e-15));
    CHECK(impact.pair_kind == HS_PAIR_FACE_VERTEX);
    CHECK(impact.feature_a == 2);
    CHECK(impact.gap > 0);
    CHECK(impact.gap < 1e-11);
    CHECK(impact.normal[0] == 0);
    CHECK(impact.normal[1] == 1);
    CHECK(impact.point[0] == Approx(far + 0.25 + 7 * expected).epsilon(1e-12));
    CHECK(impact.point[1] == Approx(0.0025).epsilon(1e-9));
    CHECK(impact.point[2] == 0);
  }
  const hs_impact never = impact_of(plate, motion(0, 0, 0, 0), bar, motion(0, 1, 0, -300), 0.003, context);
  CHECK(never.state == HS_IMPACT_NEVER);
  CHECK(never.time == 0.003);
  const hs_impact at_start = impact_of(plate, motion(0, 0, 0, 0), bar, motion(0, 0.05, 0, 300), 1, context);
  CHECK(at_start.state == HS_IMPACT_AT_START);
  CHECK(at_start.time == 0);
  CHECK(at_start.gap == Approx(-0.0025));
  CHECK(at_start.normal[1] == 1);
}

TEST_CASE("A duration of 0 is a look at the start") {
  const Context context = make_context();
  const Shape square = make_shape(context.get(), box(0, 0, 1, 1));
  CHECK(impact_of(square, motion(0, 0, 1, 1), square, motion(1, 0, 5, 5), 0, context).state ==
        HS_IMPACT_AT_START);
  CHECK(impact_of(square, motion(0, 0, 1, 1), square, motion(1.5, 0, -5, 5), 0, context).state ==
        HS_IMPACT_NEVER);
}

TEST_CASE("A cube that turns about an axis strikes with its edge, and one that is strained with its face") {
  const Context context = make_context();
  const Shape solid = make_polyhedron(context.get(), cube());
  const hs_motion_def still = motion(0, 0, 0, 0);
  const hs_impact turned = impact_of(solid, still, solid, motion(1.1, 0, 0, 0, 1), 1, context);
  CHECK(turned.state == HS_IMPACT_TOUCH);
  // The corner at half the diagonal comes round to 0.6.
  CHECK(turned.time == Approx(0.25 * std::acos(-1.0) - std::acos(0.6 / std::sqrt(0.5))).epsilon(1e-11));
  CHECK(turned.pair_kind == HS_PAIR_FACE_VERTEX);
  CHECK(turned.normal[0] == 1);

  hs_motion_def strained = motion(1.1, 0, 0, 0);
  strained.gradient_rate[0] = 1;
  const hs_impact stretched = impact_of(solid, still, solid, strained, 1, context);
  CHECK(stretched.state == HS_IMPACT_TOUCH);
  CHECK(stretched.time == Approx(0.2).epsilon(1e-11));
  strained.gradient[0] = 1.25;
  CHECK(impact_of(solid, still, solid, strained, 1, context).state == HS_IMPACT_AT_START);
}

TEST_CASE("hs_pair_time_of_impact refuses what is wrong by name and value, and writes nothing") {
  const Context context = make_context();
  const Shape square = make_shape(context.get(), box(0, 0, 1, 1)),
              solid = make_polyhedron(context.get(), cube());
  const hs_motion_def still = motion(0, 0, 0, 0);
  hs_impact impact{};
  impact.state = 7;
  const hs_impact untouched = impact;
  const auto with = [&](auto change) {
    return [&, change] {
      hs_motion_def changed = still;
      change(changed);
      return hs_pair_time_of_impact(square.get(), &still, square.get(), &changed, 2, &impact);
    };
  };
  using M = hs_motion_def;
  check_refusals(
      context.get(), "hs_pair_time_of_impact",
      {{"shape_b", "NULL",
        [&] { return hs_pair_time_of_impact(square.get(), &still, nullptr, &still, 1, &impact); }},
       {"motion_a", "NULL",
        [&] { return hs_pair_time_of_impact(square.get(), nullptr, square.get(), &still, 1, &impact); }},
       {"impact", "NULL",
        [&] { return hs_pair_time_of_impact(square.get(), &still, square.get(), &still, 1, nullptr); }},
       {"shape_b", "dimension 2",
        [&] { return hs_pair_time_of_impact(square.get(), &still, solid.get(), &still, 1, &impact); }},
       {"duration", "-1",
        [&] { return hs_pair_time_of_impact(square.get(), &still, square.get(), &still, -1, &impact); }},
       {"duration", "nan",
        [&] { return hs_pair_time_of_impact(square.get(), &still, square.get(), &still, NAN, &impact); }},
       {"motion_b.struct_size", "4", with([](M& m) { m.struct_size = 4; })},
       {"motion_b.start", "(0, 0, 0, 2)", with([](M& m) { m.start.rotation[3] = 2; })},
       {"motion_b.velocity[1]", "1e+75", with([](M& m) { m.velocity[1] = 1e75; })},
       {"motion_b.velocity[0]", "nan", with([](M& m) { m.velocity[0] = NAN; })},
       {"motion_b.angular_velocity[2]", "600000", with([](M& m) { m.angular_velocity[2] = 6e5; })},
       {"motion_b.gradient[4]", "inf", with([](M& m) { m.gradient[4] = INFINITY; })},
       {"motion_b.gradient", "-1", with([](M& m) { m.gradient[0] = -1; })},
       {"motion_b.gradient at the end", "-1", with([](M& m) { m.gradient_rate[0] = -1; })},
       {"motion_b.gradient_rate", "inverts the shape",
        with([](M& m) { m.gradient_rate[0] = m.gradient_rate[4] = -1.5; })}});
  CHECK(std::memcmp(&impact, &untouched, sizeof impact) == 0);
}

}  // namespace halfspace_test
