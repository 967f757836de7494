// Potentials on a terrain, against one fixed block. The blocks behind two triangles overlap below their edge,
// between flanks that are d / tan(60) wide on either side at the depth d. There the depths in both add up to
// that below one plane, and the potential of a block above counts twice: per length of the edges below it the
// force k d^2 / tan(60) and the energy k d^3 / (3 tan(60)), for H = 1 m.

#include <map>

#include "blocks/terrain/terrain_blocks.h"
#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;
using halfspace::cli::TriangleSurface;

const double tan_60 = std::sqrt(3.0);
constexpr double along = 1, across = 1.1, height = 0.5;  // of the box
constexpr double base = along * across, density = 2000, mass = density * base * height;

/// A flat grid around the origin with diagonals in alternate directions. Uneven: its inner nodes are moved by
/// up to a fifth of the spacing.
TriangleSurface flat_terrain(double spacing, bool is_even) {
  const int n = int(std::lround(4 / spacing));
  TriangleSurface surface;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool is_inner = 0 < i && i < n && 0 < j && j < n;
      const double moved = is_even || !is_inner ? 0 : 0.2 * spacing, direction = 3 * i + 5 * j;
      surface.vertices.push_back(
          {i * spacing - 2 + moved * std::cos(direction), j * spacing - 2 + moved * std::sin(direction), 0});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      const bool is_odd = (i + j) % 2 == 1;
      surface.triangles.push_back({a, b, is_odd ? d : c});
      surface.triangles.push_back({is_odd ? a : b, d, c});
    }
  }
  return surface;
}

/// What of a terrain lies below a block whose centre is at x and y.
struct Below {
  double edges = 0;          // their length
  int points = 0;            // nodes, and crossings of edges with the block's outline
  double sharpest = pi / 2;  // angle of a triangle

  Below(const TriangleSurface& surface, double x, double y) {
    const double low[2] = {x - along / 2, y - across / 2}, high[2] = {x + along / 2, y + across / 2};
    std::map<std::pair<int, int>, bool> seen;
    for (const std::array<int, 3>& corners : surface.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto vertex = [&](std::size_t k) {
          return surface.vertices[std::size_t(corners[(i + k) % 3])];
        };
        const Triple one = vertex(1) - vertex(0), other = vertex(2) - vertex(0);
        sharpest =
            std::min(sharpest, std::acos(dot(one, other) / std::sqrt(dot(one, one) * dot(other, other))));
        if (!seen.emplace(std::minmax(corners[i], corners[(i + 1) % 3]), true).second) continue;
        double from = 0, to = 1;
        for (std::size_t k = 0; k < 2; ++k) {
          if (one[k] == 0) {
            if (vertex(0)[k] < low[k] || vertex(0)[k] > high[k]) to = 0;
            continue;
          }
          const double at_low = (low[k] - vertex(0)[k]) / one[k], at_high = (high[k] - vertex(0)[k]) / one[k];
          from = std::max(from, std::min(at_low, at_high));
          to = std::min(to, std::max(at_low, at_high));
        }
        if (!(from < to)) continue;
        edges += (to - from) * std::sqrt(dot(one, one));
        points += 2;  // a node counts once per edge
      }
    }
  }

  /// At a point up to 8 blocks overlap, behind the corners of their flanks, within the distance
  /// d / (tan(60) sin(half an angle)) at the depth d. In this cone each potential may miss or count too often
  /// each of them: of the terrain, and of the block above.
  double force_error(double depth) const {
    const double reach = 1 / (tan_60 * std::sin(sharpest / 2));
    return points * 2 * 8 * pi * reach * reach * depth * depth * depth / 3;
  }
};

/// A box over the terrain, or over one fixed block.
struct OverGround : SolidScene {
  hs_block box = 0;

  OverGround(const TriangleSurface* surface, const hs_law_def& law, double time_step, double weight,
             const SolidStart& start)
      : SolidScene(definition(time_step, weight), law, density) {
    if (surface) {
      const halfspace::cli::Context borrowed = halfspace::cli::borrowed(context());
      make_terrain_blocks(borrowed, *surface, 1, [&](const halfspace::cli::TerrainBlock& behind) {
        hs_block_def def;
        check(hs_block_def_init(&def, sizeof def, behind.shape.get()));
        def.kind = HS_BLOCK_FIXED;
        for (std::size_t k = 0; k < 3; ++k) def.pose.position[k] += behind.place[k];
        hs_block block = 0;
        check(hs_world_add_block(world(), behind.shape.get(), &def, &block));
      });
    } else {
      SolidStart ground;
      ground.position = {0, 0, -0.5};
      ground.kind = HS_BLOCK_FIXED;
      add_hull(cuboid({4, 4, 1}), ground);
    }
    box = add_hull(cuboid({along, across, height}), start);
  }

  static hs_world_def definition(double time_step, double gravity) {
    hs_world_def def = solid_world_def(time_step, {0, 0, -gravity});
    def.potential_length = 1;
    return def;
  }
};

/// At rest in the depth d, with its centre at x and y.
SolidStart at_depth(double x, double y, double depth, double speed = 0) {
  SolidStart start;
  start.position = {x, y, height / 2 - depth};
  start.velocity = {speed, 0, 0};
  return start;
}

/// The terrain pushes with k A d; the box with the cell of its base, whose four sides lean by 45 degrees.
double force_on_one_block(double depth) {
  return 2 * base * depth - (along + across) * depth * depth + 4.0 / 3 * depth * depth * depth;
}

/// By Newton's method, over edges of a length.
double rest_depth(double weight_over_stiffness, double edges) {
  const double stiffness = 2 * base;
  double depth = weight_over_stiffness / stiffness;
  for (int i = 0; i < 20; ++i)
    depth -= (force_on_one_block(depth) + edges * depth * depth / tan_60 - weight_over_stiffness) / stiffness;
  return depth;
}

constexpr double x = -0.02, y = 0.08;  // no edge of the even grid is along the block's outline

}  // namespace

TEST_CASE("by potentials a terrain pushes as one block, and by two triangles over each edge", "[terrain]") {
  const double spacing = GENERATE(0.5, 0.25), depth = GENERATE(1e-5, 1e-4);
  const bool is_even = GENERATE(true, false);
  constexpr double stiffness = 1e8;
  const TriangleSurface surface = flat_terrain(spacing, is_even);
  const auto force = [&](const TriangleSurface* ground) {
    OverGround scene(ground, potential_law(stiffness), 1e-5, 0, at_depth(x, y, depth));
    scene.step(0);
    return scene.state(scene.box).force[2] / stiffness;
  };
  const Below below(surface, x, y);
  const double one = force(nullptr), more = force(&surface) - one,
               expected = below.edges * depth * depth / tan_60;
  std::printf(
      "terrain, spacing %.2f m, depth %.0e m: force on one block %.3e k, more %.4e k of %.4e k +- %.0e k\n",
      spacing, depth, one, more, expected, below.force_error(depth));
  CHECK(one == Approx(force_on_one_block(depth)).epsilon(1e-10));
  CHECK(std::abs(more - expected) <= below.force_error(depth));
  CHECK(below.force_error(depth) < 0.5 * expected);
}

/// The force of each edge acts on the box beside its middle: the tilt moves the middle of the box by its
/// square only.
TEST_CASE("by potentials a box rests on a terrain as deep as its edges let it", "[terrain]") {
  const bool is_even = GENERATE(true, false);
  constexpr double stiffness = 1e8, weight = mass * 9.81;
  const TriangleSurface surface = flat_terrain(0.25, is_even);
  const Below below(surface, x, y);
  const double expected = rest_depth(weight / stiffness, below.edges),
               on_one = rest_depth(weight / stiffness, 0);
  hs_law_def law = potential_law(stiffness);
  law.normal_damping = 0.5;
  OverGround scene(&surface, law, 1e-4, 9.81, at_depth(x, y, on_one));
  scene.step(5000);
  const double depth = height / 2 - scene.place_of(scene.box)[2];
  const double error = below.force_error(on_one) / (2 * base);
  std::printf("terrain: rests %.9f m deep, expected %.9f m +- %.0e m, on one block %.9f m\n", depth, expected,
              error, on_one);
  CHECK(std::abs(depth - expected) <= error);
  CHECK(on_one - expected > 2 * error);
}

/// Over edges of the length L the box has k d^3 L / (3 tan(60)) less of its motion. What remains is its
/// swing, as at the joint of two boundaries: at the start the push of all edges tilts the box.
TEST_CASE("by potentials a box slides over the edges of a terrain as over one block", "[terrain]") {
  constexpr double stiffness = 1e8, speed = 1, weight = mass * 9.81, time_step = 5e-5;
  const TriangleSurface surface = flat_terrain(0.8, false);
  const double start = -0.7, depth = rest_depth(weight / stiffness, Below(surface, start, y).edges);
  OverGround scene(&surface, potential_law(stiffness), time_step, 9.81, at_depth(start, y, depth, speed));
  double least = HUGE_VAL, most = 0, lost = 0, error = 0;
  const double edges_before = Below(surface, start, y).edges;
  for (int i = 0; i < 140; ++i) {
    scene.step(200);
    const hs_block_state now = scene.state(scene.box);
    const double edges = Below(surface, now.pose.position[0], y).edges;
    least = std::min(least, edges);
    most = std::max(most, edges);
    const double less = mass / 2 * (square_of(speed) - square_of(now.velocity[0]));
    const double expected = stiffness * depth * depth * depth * (edges - edges_before) / (3 * tan_60);
    lost = std::max(lost, std::abs(less));
    error = std::max(error, std::abs(less - expected));
  }
  const double push = stiffness * depth * depth * most / tan_60;
  const double swing = 2 * 4 * (1 + 3) * push * push / (2 * stiffness * base) / 2;
  std::printf(
      "terrain: over %.2f to %.2f m of edges up to %.2e J of %.0f J lost, %.1e J unexpected, at most %.1e "
      "J\n",
      least, most, lost, mass / 2 * square_of(speed), error, swing);
  CHECK(error <= swing);
  CHECK(most - least > 0.2 * most);
}
