// Blocks that were meant to touch do so at first whatever rounding makes of their corners: none is in contact
// (eq. 11 in its strict form), and once they press on each other they do it squarely.

#include <random>

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr int size = 5;

/// How far a normal is from the nearest of a few directions and their opposites.
double obliqueness(const double normal[3], const std::vector<Triple>& directions) {
  double least = 2;
  for (const Triple& d : directions)
    for (const double sign : {-1.0, 1.0}) least = std::min(least, length(triple(normal) - sign * d));
  return least;
}

void check_start(Scene& scene, const std::vector<Triple>& directions) {
  scene.check(hs_world_detect(scene.world(), nullptr));
  CHECK(scene.contacts().empty());
  // A few steps turn no block by as much as 1e-6.
  scene.step(5);
  const std::vector<hs_contact> contacts = scene.contacts();
  CHECK_FALSE(contacts.empty());
  double oblique = 0;
  for (const hs_contact& contact : contacts) {
    if (contact.type != HS_CONTACT_VERTEX_VERTEX)  // corner on corner: no face looks at the other
      oblique = std::max(oblique, obliqueness(contact.normal, directions));
  }
  CHECK(oblique < 1e-6);
}

hs_law_def stone_law(int32_t kind) {
  hs_law_def law = spring_law(1e8, 30 * degree);
  law.stiffness_kind = kind;
  return law;
}

}  // namespace

TEST_CASE("a neat wall starts without contacts, turned by any angle and anywhere") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const double angle = pi * uniform(random), c = std::cos(angle), s = std::sin(angle);
    const double away = std::pow(10, 1 + 3 * uniform(random));
    const Point origin{away * uniform(random), away * uniform(random)};
    const auto turned = [&](double x, double y) {
      return Point{origin.x + c * x - s * y, origin.y + s * x + c * y};
    };
    hs_world_def def = world_def(1e-4);
    def.gravity[0] = 9.81 * s;
    def.gravity[1] = -9.81 * c;
    Scene scene(def, stone_law(all_stiffness_kinds[trial % 3]));
    scene.add({turned(-1, -1), turned(6, -1), turned(6, 0), turned(-1, 0)}, {HS_BLOCK_FIXED, {}, 0});
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const double x = column + 0.5 * (trial % 2) * (row % 2), y = 0.3 * row;
        scene.add({turned(x, y), turned(x + 1, y), turned(x + 1, y + 0.3), turned(x, y + 0.3)});
      }
    }
    INFO("angle " << angle << ", " << away << " m away");
    check_start(scene, {{c, s, 0}, {-s, c, 0}});
  }
}

TEST_CASE("a wall of cuboids in space starts without contacts, turned in any way and anywhere") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 30; ++trial) {
    const double a = pi * uniform(random), b = pi * uniform(random);
    const std::vector<Triple> axes{{std::cos(a), std::sin(a), 0},
                                   {-std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)},
                                   {std::sin(a) * std::sin(b), -std::cos(a) * std::sin(b), std::cos(b)}};
    const double away = std::pow(10, 1 + 3 * uniform(random));
    const Triple origin{away * uniform(random), away * uniform(random), away * uniform(random)};
    const auto corners = [&](const Triple& low, const Triple& high) {
      Corners points;
      for (int k = 0; k < 8; ++k) {
        const Triple p{k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]};
        Triple q = origin;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) q[i] += p[j] * axes[j][i];
        points.push_back(q);
      }
      return points;
    };
    SolidScene scene(solid_world_def(1e-4, -9.81 * axes[2]), stone_law(all_stiffness_kinds[trial / 2 % 3]),
                     2000);
    const auto add = [&](const Triple& low, const Triple& high, int32_t kind) {
      scene.add_hull_in_place(corners(low, high), kind);
    };
    add({-1, -1, -1}, {4, 4, 0}, HS_BLOCK_FIXED);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          const double x = i + 0.5 * (trial % 2) * (k % 2), y = j, z = 0.3 * k;
          add({x, y, z}, {x + 1, y + 1, z + 0.3}, HS_BLOCK_RIGID);
        }
      }
    }
    INFO("turned by " << a << " and " << b << ", " << away << " m away");
    check_start(scene, axes);
  }
}
