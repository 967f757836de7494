// A block slides down a slope (Wang et al. 2021, section 4.1, and Zheng et al. 2020, section 4.3, in the
// plane): s = 1/2 (g sin - g cos tan(phi)) t^2.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double slope = 30 * degree;
constexpr double gravity = 9.81;
const Point downhill{std::cos(slope), -std::sin(slope)};
const Point upward{std::sin(slope), std::cos(slope)};

struct Slider {
  double width;
  double height;
  double density;
  double stiffness;
  double friction_angle;
  double duration;
  int32_t stiffness_kind = HS_STIFFNESS_PER_CONTACT;
  bool preloaded = true;

  double weight() const { return width * height * density * gravity; }
  double normal_force() const { return weight() * std::cos(slope); }
  /// What friction takes up: all of the weight's share if it can.
  double shear_force() const {
    return std::min(normal_force() * std::tan(friction_angle), weight() * std::sin(slope));
  }
};

/// How the block rests on its springs: height of the centroid above the plane, and forward tilt.
struct Rest {
  double height;
  double tilt;
};

/// How far it sinks in when it is level: potentials push from above and from below. The others start their
/// iteration from there.
double sink(const Slider& s) { return s.normal_force() / (2 * s.stiffness * s.width); }

/// Springs K/2 under both corners, at (+-w/2 c - h/2 s, +-w/2 s) relative to the middle of the base: sum of
/// depths = 2 N/K, sum of moments = K w^2 s c / 4 - N h s / 2 = y T.
Rest rest_on_corners(const Slider& s, const Rest& rest) {
  const double c = std::cos(rest.tilt), n = s.normal_force();
  const double height = s.height * c / 2 - n / s.stiffness;
  return {height, std::asin(height * s.shear_force() /
                            (s.stiffness * square_of(s.width) * c / 4 - n * s.height / 2))};
}

/// Per area friction acts at the depth of the overlap's centroid: of a trapezoid with a depth at the toe and
/// one at the heel, or of a triangle without a heel.
double friction_arm(const Slider& s, const Rest& rest) {
  const double c = std::cos(rest.tilt), sine = std::sin(rest.tilt);
  const double toe = (s.height * c + s.width * sine) / 2 - rest.height;
  const double heel = std::max((s.height * c - s.width * sine) / 2 - rest.height, 0.0);
  return rest.height + (toe * toe + toe * heel + heel * heel) / (3 * (toe + heel));
}

/// Depth d0 + tan(tilt) x under a base of length w c: force K w c d0, moment about its middle K tan(tilt) (w
/// c)^3 / 12; its middle lies h/2 sin(tilt) behind the centroid.
Rest rest_on_whole_base(const Slider& s, const Rest& rest) {
  const double c = std::cos(rest.tilt), n = s.normal_force();
  const double base = s.width * c;
  const double height = s.height * c / 2 - n / (s.stiffness * base);
  const double arm = friction_arm(s, {height, rest.tilt});
  return {height, std::atan((arm * s.shear_force() + n * s.height / 2 * std::sin(rest.tilt)) /
                            (s.stiffness * base * base * base / 12))};
}

/// The tail is lifted, and what lies below the plane is a triangle with a length b of the base and its right
/// angle at the toe, at (w/2 c - h/2 s, -h/2 c - w/2 s) from the centroid: K tan(tilt) b^2 / 2 = N, and its
/// centroid, b c - b (c + 1/c) / 3 behind the toe, is y T / N ahead of that of the block.
Rest rest_on_front_of_base(const Slider& s, const Rest& rest) {
  const double c = std::cos(rest.tilt), sine = std::sin(rest.tilt), n = s.normal_force();
  const double toe_ahead = (s.width * c - s.height * sine) / 2;
  const double bearing = (toe_ahead - friction_arm(s, rest) * s.shear_force() / n) / (c - (c + 1 / c) / 3);
  return {(s.height * c + s.width * sine) / 2 - bearing * sine,
          std::atan(2 * n / (s.stiffness * square_of(bearing)))};
}

constexpr double potential_length = 1;

/// What potentials do to the block, per k/H, when its centroid is at this height above the plane and it is
/// tilted forward.
struct PotentialPush {
  double force;   // along the plane's normal; along the plane there is none, as nothing changes that way
  double moment;  // about the centroid, forward
  double friction_arm;  // of the loading point below the centroid
};

/// In the block's frame, x forward and z up from the base's middle, the plane is the line z = h/2 - y /
/// cos(tilt) + x tan(tilt): what lies below is a trapezoid with a depth at the toe and one at the heel, or a
/// triangle without a heel. The plane pushes along its normal (-sin, cos) at the centroid. The block's own
/// faces push it back, the base at the foot of what is nearer to it than to the sides: of all but the two
/// triangles along the sides, whose third corner is on the bisector.
PotentialPush potential_push(const Slider& s, const Rest& rest) {
  const double c = std::cos(rest.tilt), sine = std::sin(rest.tilt), slant = sine / c;
  const double half = s.width / 2, middle = s.height / 2 - rest.height / c;
  const double toe = middle + slant * half, heel = std::max(middle - slant * half, 0.0);
  const double base = middle - slant * half > 0 ? s.width : toe / slant;

  struct Part {
    double area, x, z;
  };
  const double ramp = slant * base;  // the trapezoid is a rectangle with this on it
  const Part rectangle{base * heel, half - base / 2, heel / 2};
  const Part wedge{base * ramp / 2, half - base / 3, heel + ramp / 3};
  const double ridge_toe = toe / (1 + slant), ridge_heel = heel / (1 - slant);
  const Part at_toe{toe * ridge_toe / 2, half - ridge_toe / 3, (toe + ridge_toe) / 3};
  const Part at_heel{heel * ridge_heel / 2, ridge_heel / 3 - half, (heel + ridge_heel) / 3};

  const double area = rectangle.area + wedge.area, under_base = area - at_toe.area - at_heel.area;
  const double x_sum = rectangle.area * rectangle.x + wedge.area * wedge.x;
  const double z_sum = rectangle.area * rectangle.z + wedge.area * wedge.z;
  const double base_x_sum = x_sum - at_toe.area * at_toe.x - at_heel.area * at_heel.x;
  const double lever = s.height / 2;  // z of the centroid
  PotentialPush push;
  push.force = area + under_base * c + (at_toe.area - at_heel.area) * sine;
  // Forward is clockwise: force_x times z less force_z times x.
  push.moment = -sine * (z_sum - lever * area) - c * x_sum - base_x_sum - at_toe.area * (at_toe.z - lever) +
                at_heel.area * (at_heel.z - lever);
  push.friction_arm = (lever - z_sum / area) * c + x_sum / area * sine;
  return push;
}

/// Force N and no moment, by a step of Newton's iteration with differences for its slopes. The tilt is taken
/// as a height, that of half the base.
Rest rest_on_potentials(const Slider& s, const Rest& rest) {
  const auto unbalanced = [&](double sunk, double tipped) {
    const PotentialPush push = potential_push(s, {rest.height - sunk, rest.tilt + 2 * tipped / s.width});
    const double stiffness = s.stiffness / potential_length;
    return Point{stiffness * push.force - s.normal_force(),
                 stiffness * push.moment + s.shear_force() * push.friction_arm};
  };
  const double small = 1e-3 * sink(s);
  const auto slope = [&](double sunk, double tipped) {
    const Point above = unbalanced(sunk, tipped), below = unbalanced(-sunk, -tipped);
    return Point{(above.x - below.x) / (2 * small), (above.y - below.y) / (2 * small)};
  };
  const Point error = unbalanced(0, 0), by_sunk = slope(small, 0), by_tipped = slope(0, small);
  const double determinant = by_sunk.x * by_tipped.y - by_sunk.y * by_tipped.x;
  const double sunk = (by_tipped.x * error.y - by_tipped.y * error.x) / determinant;
  const double tipped = (by_sunk.y * error.x - by_sunk.x * error.y) / determinant;
  return {rest.height - sunk, rest.tilt + 2 * tipped / s.width};
}

/// The shear force acts at the base, at the height y below the centroid, and turns the block until the normal
/// force is ahead of the centroid by y T / N. Found by iteration: the tilt is of the order of the overlap.
/// The whole base bears while the normal force is in its middle third.
Rest rest_of(const Slider& s) {
  Rest rest{s.height / 2 - sink(s), 0};
  for (int i = 0; i < 50; ++i) {
    const bool is_whole = rest.height * s.shear_force() <= s.normal_force() * s.width / 6;
    rest = s.stiffness_kind == HS_STIFFNESS_PER_CONTACT ? rest_on_corners(s, rest)
           : s.stiffness_kind == HS_STIFFNESS_POTENTIAL ? rest_on_potentials(s, rest)
           : is_whole                                   ? rest_on_whole_base(s, rest)
                                                        : rest_on_front_of_base(s, rest);
  }
  return rest;
}

struct Slide {
  double distance;
  double friction_loss;
  double residual;
};

Slide run(const Slider& s) {
  const double time_step = 1e-5;
  hs_law_def law = spring_law(s.stiffness, s.friction_angle);
  law.stiffness_kind = s.stiffness_kind;
  hs_world_def def = world_def(time_step, -gravity);
  def.potential_length = potential_length;
  Scene scene(def, law, s.density);
  // A plane that is long enough, its upper side through the origin where the block starts.
  const double run_off = 0.5 * gravity * square_of(s.duration) + 2 * s.width;
  const Points plane_outline = rectangle(2 * run_off, 1);
  const hs_block plane =
      scene.add_at(plane_outline, {-0.5 * upward.x, -0.5 * upward.y}, -slope, {HS_BLOCK_FIXED, {}, 0});
  const Rest rest = s.preloaded ? rest_of(s) : Rest{s.height / 2, 0};
  const hs_block block = scene.add_at(rectangle(s.width, s.height),
                                      {rest.height * upward.x, rest.height * upward.y}, -slope - rest.tilt);
  if (s.preloaded && s.friction_angle > 0) scene.preload_shear(plane, block, s.shear_force());
  const Point from = scene.position(block);
  scene.step(std::llround(s.duration / time_step));
  const Point to = scene.position(block);
  const hs_energy energy = scene.energy();
  return {(to.x - from.x) * downhill.x + (to.y - from.y) * downhill.y, energy.friction_loss, energy.residual};
}

/// Constant acceleration is exact in velocity Verlet, whatever the step. What is left when the springs start
/// in equilibrium is rounding of the block's place: coordinates of some 10 m (rounding 2e-15 m) give the
/// overlap N/K, and so the normal force, a relative error of 2e-15 K / N (5e-11 for the stiffer, A4.1),
/// shaken once more with every of up to 5e5 steps as the block moves; were all these errors of one sign and
/// undamped, sqrt(steps) of them add up: 4e-8.
constexpr double required = 1e-4;
constexpr double derived = 4e-8;

void check_slide(const char* name, Slider s) {
  const double acceleration = gravity * (std::sin(slope) - std::cos(slope) * std::tan(s.friction_angle));
  const double exact = 0.5 * acceleration * square_of(s.duration);
  const Slide slide = run(s);
  s.preloaded = false;
  const Slide unloaded = run(s);
  const double error = slide.distance / exact - 1;
  std::printf(
      "%s, friction %2.0f deg: slide %.9f m, relative error %9.2e (not preloaded %9.2e), friction loss off "
      "by %9.2e\n",
      name, s.friction_angle / degree, slide.distance, error, unloaded.distance / exact - 1,
      slide.friction_loss - s.shear_force() * slide.distance);
  CHECK(std::abs(error) <= required);
  CHECK(std::abs(error) <= derived);
  // Friction takes F s.
  CHECK(std::abs(slide.friction_loss - s.shear_force() * slide.distance) <=
        derived * s.weight() * slide.distance);
}

TEST_CASE("A4.1 a block of 5 x 4 m slides down 30 degrees as the formula says") {
  for (double friction : {15.0, 20.0, 25.0}) {
    check_slide("A4.1", {5, 4, 2500, 1e10, friction * degree, 5});
  }
}

TEST_CASE("A4.1 a block stays on a slope as steep as its friction angle") {
  Slider s{5, 4, 2500, 1e10, slope, 5};
  const double creep = run(s).distance / s.width;
  s.preloaded = false;
  std::printf("A4.1, friction 30 deg: creep in 5 s %.2e of the width (not preloaded %.2e)\n", creep,
              run(s).distance / s.width);
  // By the same rounding, 4e-8 of the free slide of 1/2 g sin t^2 = 61 m at most, which is 5e-7 of the width.
  CHECK(std::abs(creep) < 1e-6);
}

TEST_CASE("B4.3 a block of 1 m slides down 30 degrees as the formula says") {
  // With the stiffness per area the whole base bears up to 18 degrees, and the front of it at 20. So it does
  // with potentials, which are nearly as hard as twice that.
  for (int32_t kind : all_stiffness_kinds) {
    const std::string name = std::string("B4.3 ") + name_of_stiffness(kind);
    for (double friction : {0.0, 10.0, 20.0})
      check_slide(name.c_str(), {1, 1, 2000, 1e7, friction * degree, 2, kind});
  }
}

}  // namespace
