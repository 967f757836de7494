#include "world/motion/stable_step.h"

#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 48, density = 3, depth = 0x1p-14;

template <int D>
double bound_of(WorldParts<D>& parts) {
  parts.list_neighbors();
  parts.find_contacts();
  return parts.stable_step.bound();
}

/// A free bar along x, thin in y, on small fixed blocks at its ends, above and below.
struct ClampedBar : WorldParts<2> {
  static constexpr double length = 16, height = 0.25, support = 0.25;
  double mass = density * length * height;

  explicit ClampedBar(const ContactLaw& law, const WorldSettings<2>& settings = {})
      : WorldParts<2>(law, settings, density) {
    add(cuboid<2>({length, height}), BlockKind::rigid, {0, 0});
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        add(cuboid<2>({support, support}), BlockKind::fixed,
            {2 * x * (length - support) / 2, 2 * y * ((height + support) / 2 - depth)});
    list_neighbors();
    find_contacts();
    REQUIRE(contacts.count() == 4);
  }

  /// The frequency of its rocking by four springs at the ends: k x^2 each over m (l^2 + h^2) / 12.
  double frequency() const {
    const double arm = (length - support) / 2;
    return std::sqrt(4 * stiffness * arm * arm / (mass * (length * length + height * height) / 12));
  }
};

/// A free bar or plate on a row of n fixed blocks along x: it bounces as one mass on n springs.
template <int D>
struct Row : WorldParts<D> {
  explicit Row(int n, double stiff = stiffness, double dense = density,
               BlockKind of_supports = BlockKind::fixed, double height = 1)
      : WorldParts<D>(normal_spring(stiff), {}, dense) {
    Vector<D> sides = Vector<D>::Constant(0x1p-4);
    sides[1] = height;
    for (int i = 0; i < n; ++i) this->add(cuboid<D>(sides), of_supports, at<D>(2 * i + 1 - n, -height / 2));
    sides = Vector<D>::Ones();
    sides[0] = 2 * n;
    this->add(cuboid<D>(sides), BlockKind::rigid, at<D>(0, 0.5 - depth));
  }
};

}  // namespace

/// The bound takes the moment of each spring to act at the tip, (1 + 3) k / m against 3 k / m, and adds what
/// the supports' width does.
TEST_CASE("of a bar on springs at its ends the stable step is below that of its rocking by a sixth") {
  ClampedBar bar(normal_spring(stiffness));
  const double limit = 2 / bar.frequency(), bound = bar.stable_step.bound();
  CHECK(bound <= limit);
  CHECK(bound >= 0.8 * limit);
}

/// Verlet's method with dashpots that read the velocity of half a step before is stable as long as dt^2
/// omega^2 + 4 dt zeta omega < 4.
TEST_CASE("dashpots shorten the stable step as they do that of an oscillator") {
  for (const double damping : {0.1, 0.5, 1.0}) {
    ContactLaw law = normal_spring(stiffness);
    law.normal_damping = damping;
    ClampedBar bar(law);
    const double arm = (bar.length - bar.support) / 2, inertia = bar.mass * (16 * 16 + 0.25 * 0.25) / 12;
    const double viscosity = 2 * damping * std::sqrt(stiffness * bar.mass);
    const double gamma = 4 * viscosity * arm * arm / inertia, omega = bar.frequency();
    const double limit = (std::sqrt(gamma * gamma + 4 * omega * omega) - gamma) / (omega * omega);
    INFO(damping);
    CHECK(bar.stable_step.bound() <= limit);
    CHECK(bar.stable_step.bound() >= 0.7 * limit);
  }
}

TEST_CASE("mass damping shortens the stable step as dashpots do, and tells none by itself") {
  for (const double share : {0.01, 1.0, 10.0}) {
    WorldSettings<2> settings;
    ClampedBar free(normal_spring(stiffness));
    const double omega = 2 / free.stable_step.bound(), gamma = share * omega;
    settings.mass_damping = gamma;
    ClampedBar bar(normal_spring(stiffness), settings);
    const double limit = (std::sqrt(gamma * gamma + 4 * omega * omega) - gamma) / (omega * omega);
    CHECK(bar.stable_step.bound() == Approx(limit).epsilon(1e-12));
    ContactLaw no_spring = normal_spring(stiffness);
    no_spring.stiffness_kind = StiffnessKind::none;
    WorldParts<2> parts(no_spring, settings);
    parts.add(cube<2>(), BlockKind::rigid, at<2>(0, 0));
    CHECK(std::isinf(bound_of<2>(parts)));
  }
}

/// All contacts count, and at least four: n k / m is the square of the frequency. The bound lets each act on
/// the corner that yields most: by 4 / m in the plane, and 7 / m in space, where a bar also turns about its
/// length.
TEMPLATE_TEST_CASE_SIG("of a bar on many springs the stable step is below two over its frequency, not by far",
                       "", ((int D), D), 2, 3) {
  for (const int n : {8, 32}) {
    Row<D> parts(n);
    const double limit = 2 / std::sqrt(n * stiffness / parts.blocks.mass[std::size_t(n)]);
    INFO(n);
    const double bound = bound_of<D>(parts);
    CHECK(parts.contacts.count() == std::size_t(n));
    CHECK(bound <= limit);
    CHECK(bound >= 0.95 / std::sqrt(D == 2 ? 4 : 7) * limit);
  }
}

TEMPLATE_TEST_CASE_SIG("a free chain's stable step is below that of its fastest vibration", "", ((int D), D),
                       2, 3) {
  constexpr int n = 20;
  WorldParts<D> parts(normal_spring(stiffness), {}, density);
  for (int i = 0; i < n; ++i) parts.add(cube<D>(), BlockKind::rigid, at<D>(i * (1 - depth), 0));
  const double omega = 2 * std::sqrt(stiffness / density) * std::sin(0.5 * pi * (n - 1) / n);
  const double bound = bound_of(parts);
  CHECK(parts.contacts.count() == n - 1);
  CHECK(bound <= 2 / omega);
  CHECK(bound >= 0.2 * 2 / omega);
}

TEST_CASE("four times as stiff is half as long a step, four times as heavy one twice as long") {
  const auto bound = [](double stiff, double dense) {
    Row<2> parts(8, stiff, dense);
    return bound_of<2>(parts);
  };
  const double once = bound(stiffness, density);
  CHECK(bound(4 * stiffness, density) == 0.5 * once);
  CHECK(bound(stiffness, 4 * density) == 2 * once);
}

TEST_CASE("a contact with a block that moves counts twice, as it may come to meet the other") {
  Row<2> fixed(8), heavy(8, stiffness, density, BlockKind::rigid, 1024);
  CHECK(bound_of<2>(heavy) == Approx(bound_of<2>(fixed) / std::sqrt(2)).epsilon(1e-12));
}

/// The frequency of a square that rocks on springs at its four corners, against neighbours that rock the
/// other way: 2 k r^2 each over I = m / 6, r^2 = 1 / 2.
TEST_CASE("contacts that are to come count: four, with blocks that move") {
  WorldParts<2> alone(normal_spring(stiffness)), fixed(normal_spring(stiffness));
  alone.add(cube<2>(), BlockKind::rigid, {0, 0});
  CHECK(bound_of(alone) <= 2 / std::sqrt(24 * stiffness));
  CHECK(bound_of(alone) >= 0.8 * 2 / std::sqrt(24 * stiffness));
  fixed.add(cube<2>(), BlockKind::fixed, {0, 0});
  CHECK(bound_of(fixed) == HUGE_VAL);
}
