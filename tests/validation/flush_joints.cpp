// A block that slides over joints of the ground keeps its way and its speed, as over a ground in one piece.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

/// How the ground is cut, 0.5 m long each.
enum class Ground { in_one_piece, flush, rounded, with_gaps, slanted, of_simplices, of_tiles, of_prisms };

const char* name_of(Ground ground) {
  constexpr const char* names[] = {"in one piece", "flush",        "off by 1e-6", "1e-3 apart",
                                   "slanted",      "of simplices", "of tiles",    "of prisms"};
  return names[int(ground)];
}

/// From -1 m on along x.
constexpr double ground_end = 4, piece = 0.5;

void add_fixed(SolidScene& scene, const Points& corners) { scene.add(corners, {HS_BLOCK_FIXED, {}, 0}); }
void add_fixed(SolidScene& scene, const Corners& corners) {
  scene.add_hull_in_place(corners, HS_BLOCK_FIXED);
}

Corners moved(Corners corners, const Triple& by) {
  for (Triple& corner : corners)
    for (std::size_t k = 0; k < 3; ++k) corner[k] += by[k];
  return corners;
}

void add_ground_in_plane(SolidScene& scene, Ground ground) {
  if (ground == Ground::in_one_piece) return add_fixed(scene, box(-1, -0.5, ground_end, 0));
  int index = 0;
  for (double x = -1; x < ground_end; x += piece, ++index) {
    switch (ground) {
      case Ground::slanted:
        add_fixed(scene, Points{{x, -0.5}, {x + piece, -0.5}, {x + piece + 0.3, 0}, {x + 0.3, 0}});
        break;
      case Ground::of_simplices:
        add_fixed(scene, Points{{x, 0}, {x + 0.5 * piece, -0.2}, {x + piece, 0}});
        add_fixed(scene, Points{{x + 0.5 * piece, -0.2}, {x + 1.5 * piece, -0.2}, {x + piece, 0}});
        break;
      default: {
        const double up = ground == Ground::rounded ? 1e-6 * (index % 2) : 0;
        const double gap = ground == Ground::with_gaps ? 1e-3 : 0;
        add_fixed(scene, box(x, -0.5, x + piece - gap, up));
      }
    }
  }
}

void add_cell(SolidScene& scene, Ground ground, double x, double y, int row) {
  const Corners cell = moved(cuboid({piece, piece, piece}), {x + 0.5 * piece, y + 0.5 * piece, -0.5 * piece});
  const auto part = [&](std::initializer_list<std::size_t> corners) {
    Corners points;
    for (const std::size_t corner : corners) points.push_back(cell[corner]);
    add_fixed(scene, points);
  };
  // The corners of a cuboid count up along x, then y, then z.
  if (ground == Ground::of_tiles) return add_fixed(scene, moved(cell, {0, 0.1 * row, 0}));
  if (ground == Ground::of_prisms) {
    part({0, 1, 3, 4, 5, 7});
    return part({0, 3, 2, 4, 7, 6});
  }
  for (const auto& [one, other] :
       {std::pair<std::size_t, std::size_t>{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}})
    part({0, one, other, 7});
}

void add_ground_in_space(SolidScene& scene, Ground ground) {
  if (ground == Ground::in_one_piece) return add_fixed(scene, moved(cuboid({5, 2, 0.5}), {1.5, 0, -0.25}));
  int row = 0;
  for (double x = -1; x < ground_end; x += piece, row = 1 - row) {
    if (ground >= Ground::of_simplices) {
      for (double y = -1; y < 1; y += piece) add_cell(scene, ground, x, y, row);
      continue;
    }
    const double up = ground == Ground::rounded ? 1e-6 * row : 0,
                 gap = ground == Ground::with_gaps ? 1e-3 : 0;
    add_fixed(scene, moved(cuboid({piece - gap, 2, 0.5}), {x + 0.5 * (piece - gap), 0, up - 0.25}));
  }
}

struct Slide {
  Triple place;
  Triple velocity;
  double residual;  // over the energy at the start
};

/// At 2 m/s for a second.
Slide slide(int dimension, int32_t kind, double friction, Ground ground) {
  hs_world_def def = solid_world_def(0, {0, dimension == 2 ? -9.81 : 0, dimension == 2 ? 0 : -9.81});
  def.dimension = dimension;
  def.potential_length = 0.3;
  hs_law_def law = spring_law(1e9, std::atan(friction));
  law.stiffness_kind = kind;
  law.normal_damping = law.shear_damping = 0.1;
  SolidScene scene(def, law, 2500);
  hs_block block;
  if (dimension == 2) {
    add_ground_in_plane(scene, ground);
    block = scene.add(box(0, 0, 0.3, 0.3), {HS_BLOCK_RIGID, {2, 0}, 0});
  } else {
    add_ground_in_space(scene, ground);
    SolidStart start{{0.15, 0.03, 0.15}, {0, 0, 0, 1}};
    start.velocity = {2, 0, 0};
    block = scene.add_hull(cuboid({0.3, 0.3, 0.3}), start);
  }
  const double energy = scene.energy().kinetic;
  while (scene.report().time < 1) scene.step(100);
  const hs_block_state state = scene.state(block);
  return {triple(state.pose.position), triple(state.velocity), scene.energy().residual / energy};
}

void compare(int dimension, std::initializer_list<Ground> grounds) {
  for (const int32_t kind : all_stiffness_kinds) {
    for (const double friction : {0.0, 0.1}) {
      const Slide expected = slide(dimension, kind, friction, Ground::in_one_piece);
      for (const Ground ground : grounds) {
        INFO(dimension << "D, " << name_of_stiffness(kind) << ", friction " << friction << ", "
                       << name_of(ground));
        const Slide found = slide(dimension, kind, friction, ground);
        CHECK(length(found.place - expected.place) < 1e-3 * 2);
        CHECK(length(found.velocity - expected.velocity) < 1e-3 * 2);
        // Springs per contact are there all at once with the corner that passes the joint.
        CHECK(found.residual < (kind == HS_STIFFNESS_PER_CONTACT ? 1e-4 : 1e-5));
      }
    }
  }
}

}  // namespace

TEST_CASE("a block slides over the joints of a ground in the plane as if there were none") {
  compare(2, {Ground::flush, Ground::rounded, Ground::with_gaps, Ground::slanted, Ground::of_simplices});
}

TEST_CASE("a block slides over the joints of a ground in space as if there were none") {
  compare(3, {Ground::flush, Ground::rounded, Ground::with_gaps, Ground::of_tiles, Ground::of_prisms,
              Ground::of_simplices});
}
