// Several faces entered in one step (Wang et al. 2021, section 2.5): a tip is outside of two or three faces
// of a block when a step begins, and inside of all when it ends. Until it has crossed the last of their
// planes it is outside of the block, so it enters through the face that it crosses last. That face has to
// push it back, however deep it is behind the others. Per contact the law keeps that face; by potentials the
// force follows from where the blocks are, and only its symmetry can be said.

#include <algorithm>

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double time_step = 0.02;

/// The tip is the deepest vertex behind both faces, and its edges are nowhere in the way of the block's
/// corner.
const Points kite = {{0, 0}, {-0.4, 1}, {-1, 0.4}};
constexpr double kite_area = 0.42;
const Corners spike = {{0, 0, 0}, {-1, -0.4, 0.4}, {-0.4, -1, 0.4}, {-0.4, -0.4, 1}};

hs_law_def law_of(int32_t kind) {
  hs_law_def law = spring_law(kind == HS_STIFFNESS_PER_CONTACT ? 2e3 : 2e4);
  law.stiffness_kind = kind;
  return law;
}

hs_world_def definition(int dimension) {
  hs_world_def def = dimension == 2 ? world_def(time_step, 0) : solid_world_def(time_step, {0, 0, 0});
  def.potential_length = 1;
  return def;
}

/// How the tip moves: a component is the way per step into the block across a face of its corner, and the
/// share of the third step in which the tip crosses that face's plane.
struct Entry {
  Triple way;
  Triple share;

  Triple tip_at_start(const Triple& inwards) const {
    Triple at{};
    for (std::size_t k = 0; k < 3; ++k) at[k] = -inwards[k] * way[k] * (2 + share[k]);
    return at;
  }
  Triple velocity(const Triple& inwards) const {
    Triple v{};
    for (std::size_t k = 0; k < 3; ++k) v[k] = inwards[k] * way[k] / time_step;
    return v;
  }
  std::size_t last() const {
    return std::size_t(std::max_element(share.begin(), share.end()) - share.begin());
  }
};

/// The first contact's normal out of the block, and the change of the velocity of the tip's block by all of
/// the contact.
struct Rebound {
  Triple normal{};
  Triple change{};
};

Rebound rebound(Scene& scene, hs_block block, hs_block thrown) {
  const Triple before = triple(scene.state(thrown).velocity);
  scene.step(2);
  REQUIRE(scene.contacts().empty());  // outside of all faces
  scene.step();
  const std::optional<hs_contact> met = scene.contact_between(block, thrown);
  REQUIRE(met);
  Rebound found;
  found.normal = (met->block_a == block ? 1.0 : -1.0) * triple(met->normal);
  for (int i = 0; i < 1000 && scene.contact_between(block, thrown); ++i) scene.step();
  REQUIRE(scene.contacts().empty());
  found.change = triple(scene.state(thrown).velocity) - before;
  return found;
}

/// Steps as coarse as these make energy, as the overlap of the first one costs no work.
Rebound rebound_in_plane(const Entry& entry, int32_t kind, const Triple& inwards, int numbered_from,
                         bool thrown_first) {
  Scene scene(definition(2), law_of(kind), 1);
  scene.let_energy_be_made();
  const Triple tip = entry.tip_at_start(inwards), velocity = entry.velocity(inwards);
  // Mirrored outlines run clockwise: they are reversed.
  const bool is_mirrored = inwards[0] * inwards[1] > 0;
  const auto placed = [&](Points points, Point at) {
    for (Point& p : points) p = {at.x + inwards[0] * p.x, at.y - inwards[1] * p.y};
    if (is_mirrored) std::reverse(points.begin(), points.end());
    std::rotate(points.begin(), points.begin() + numbered_from % std::ptrdiff_t(points.size()), points.end());
    return points;
  };
  hs_block block = 0, thrown = 0;
  const auto add_block = [&] { block = scene.add(placed(box(0, -2, 2, 0), {}), {HS_BLOCK_FIXED, {}, 0}); };
  if (!thrown_first) add_block();
  thrown = scene.add(placed(kite, {tip[0], tip[1]}), {HS_BLOCK_RIGID, {velocity[0], velocity[1]}, 0});
  if (thrown_first) add_block();
  return rebound(scene, block, thrown);
}

/// Into the corner of a cube, or over its edge along y.
Rebound rebound_in_space(const Entry& entry, bool at_corner) {
  SolidScene scene(definition(3), law_of(HS_STIFFNESS_PER_CONTACT), 1);
  scene.let_energy_be_made();
  const Triple inwards = {1, 1, -1}, tip = entry.tip_at_start(inwards), velocity = entry.velocity(inwards);
  SolidStart cube;
  cube.position = {1, at_corner ? 1.0 : 0.0, -1};
  cube.kind = HS_BLOCK_FIXED;
  const hs_block block = scene.add_hull(cuboid({2, 2, 2}), cube);
  SolidStart flight;
  flight.velocity = velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Triple& corner : spike) flight.position[k] += corner[k] / 4;
    flight.position[k] += tip[k];
  }
  return rebound(scene, block, scene.add_hull(spike, flight));
}

/// Without friction all of the impulse is along the normal of the entry, which does not turn: none of it goes
/// across, but for the rounding of each step.
void check_push(const Rebound& found, std::size_t last, const Triple& inwards) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double expected = k == last ? -inwards[k] : 0;
    CHECK(std::abs(found.normal[k] - expected) <= 4 * rounding);
    if (k != last) CHECK(std::abs(found.change[k]) <= 1e3 * rounding);
  }
  CHECK(-inwards[last] * found.change[last] > 0.1);
}

}  // namespace

/// Steep and flat ways, so that the face crossed last is the nearer or the farther one at the end of the
/// step.
TEST_CASE("two faces entered in one step: the one crossed last pushes a tip back, in the plane") {
  const Triple way = GENERATE(Triple{0.01, 0.06, 0}, Triple{0.06, 0.01, 0}, Triple{0.03, 0.03, 0});
  const Triple share = GENERATE(Triple{0.2, 0.6, 0}, Triple{0.6, 0.2, 0}, Triple{0.1, 0.15, 0});
  const Triple inwards = GENERATE(Triple{1, -1, 0}, Triple{-1, -1, 0}, Triple{1, 1, 0}, Triple{-1, 1, 0});
  const Entry entry{way, share};
  for (int numbered_from = 0; numbered_from < 4; ++numbered_from) {
    for (const bool thrown_first : {false, true}) {
      INFO("numbered from " << numbered_from << (thrown_first ? ", thrown first" : ""));
      check_push(rebound_in_plane(entry, HS_STIFFNESS_PER_CONTACT, inwards, numbered_from, thrown_first),
                 entry.last(), inwards);
    }
  }
}

TEST_CASE("two faces entered in one step: the one crossed last pushes a tip back, over an edge in space") {
  const Triple way = GENERATE(Triple{0.01, 0, 0.06}, Triple{0.06, 0, 0.01}, Triple{0.03, 0.01, 0.03});
  const Triple share = GENERATE(Triple{0.2, 0, 0.6}, Triple{0.6, 0, 0.2});
  const Entry entry{way, share};
  check_push(rebound_in_space(entry, false), entry.last(), {1, 1, -1});
}

TEST_CASE(
    "two faces entered in one step: of three at a corner, too, the one crossed last pushes a tip back") {
  const Triple way = GENERATE(Triple{0.01, 0.03, 0.05}, Triple{0.05, 0.01, 0.03}, Triple{0.03, 0.05, 0.01});
  Triple share = {0.1, 0.4, 0.7};
  do {
    const Entry entry{way, share};
    INFO("shares " << share[0] << " " << share[1] << " " << share[2]);
    check_push(rebound_in_space(entry, true), entry.last(), {1, 1, -1});
  } while (std::next_permutation(share.begin(), share.end()));
}

/// Both planes are crossed at once. Per contact either face may push; which one rounding and the numbering of
/// the vertices decide. By potentials the force is as symmetric as the blocks: to 16 roundings of places
/// about 1 m away, over an overlap of up to 0.1 m and half a second.
TEST_CASE("two faces entered in one step: along the bisector of a corner one of them, or both alike, push") {
  const Entry entry{{0.03, 0.03, 0}, {0.5, 0.5, 0}};
  const Triple inwards = {1, -1, 0};
  for (int numbered_from = 0; numbered_from < 4; ++numbered_from) {
    const Rebound found = rebound_in_plane(entry, HS_STIFFNESS_PER_CONTACT, inwards, numbered_from, false);
    check_push(found, std::abs(found.normal[1]) > 0.5 ? 1 : 0, inwards);
    const Rebound alike = rebound_in_plane(entry, HS_STIFFNESS_POTENTIAL, inwards, numbered_from, false);
    CHECK(std::abs(alike.change[0] + alike.change[1]) <= 2e4 * 16 * rounding * 0.1 * 0.5 / kite_area);
    CHECK(alike.change[1] > 0.1);
  }
}
