// Symmetric scenes stay symmetric (Zheng et al. 2020, sections 4.2 and 5.2). The papers give no coordinates.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

/// About the axis x = 0. The vertices run the other way and are given from the same one.
Points mirrored(Points p) {
  for (Point& v : p) v.x = -v.x;
  return p;
}

/// B4.2. A block falls between two gables that stand on lintels on columns. Mirror images never meet: a pair
/// that meets corner to corner on the axis has two contact planes that are as good as each other, and one
/// penalty spring has to take one.
struct SymmetricGroup {
  Scene scene;
  std::vector<std::pair<hs_block, hs_block>> pairs;

  explicit SymmetricGroup(const hs_law_def& law) : scene(world_def(1e-4), law) {
    scene.add({{-9, -1.5}, {9, -1.5}, {9, 0}, {-9, 0}}, {HS_BLOCK_FIXED, {}, 0});
    add_pair({{2.25, 0}, {3.75, 0}, {3.75, 1.5}, {2.25, 1.5}});
    add_pair({{1.875, 1.5}, {4.125, 1.5}, {4.125, 2.25}, {1.875, 2.25}});
    add_pair({{2.25, 2.25}, {3.75, 2.25}, {3, 3.75}});
    const hs_block falling =
        scene.add({{-2.25, 3}, {2.25, 3}, {2.25, 4.5}, {-2.25, 4.5}}, {HS_BLOCK_RIGID, {0, -3}, 0});
    pairs.emplace_back(falling, falling);
  }
  void add_pair(const Points& right) { pairs.emplace_back(scene.add(right), scene.add(mirrored(right))); }

  /// How far the motion is from symmetric: places, velocities and turns.
  double asymmetry() const {
    double largest = 0;
    for (auto [right, left] : pairs) {
      const hs_block_state r = scene.state(right), l = scene.state(left);
      for (double difference :
           {r.pose.position[0] + l.pose.position[0], r.pose.position[1] - l.pose.position[1],
            r.velocity[0] + l.velocity[0], r.velocity[1] - l.velocity[1], r.angle + l.angle,
            r.angular_velocity[2] + l.angular_velocity[2]}) {
        largest = std::max(largest, std::abs(difference));
      }
    }
    return largest;
  }
};

struct GroupMotion {
  double asymmetry = 0;  // the largest
  Point falling;
  Point gable;
};

GroupMotion run(SymmetricGroup& group) {
  constexpr int steps = 10000;
  GroupMotion motion;
  for (int i = 0; i < steps; ++i) {
    group.scene.step();
    motion.asymmetry = std::max(motion.asymmetry, group.asymmetry());
  }
  motion.falling = group.scene.position(group.pairs[3].first);
  motion.gable = group.scene.position(group.pairs[2].first);
  return motion;
}

void print(const GroupMotion& motion, double friction, int32_t stiffness_kind) {
  std::printf(
      "B4.2 friction %2.0f deg, %s: largest asymmetry in 1 s %.1e; fallen to %.3f m, gable at %.3f, %.3f m\n",
      friction, name_of_stiffness(stiffness_kind), motion.asymmetry, motion.falling.y, motion.gable.x,
      motion.gable.y);
}

/// It holds bit for bit: all arithmetic is even or odd under the mirror, and no block has three contacts
/// whose forces a mirror image adds up in another order.
TEST_CASE("B4.2 a mirror-symmetric group moves symmetrically") {
  for (double friction : {0.0, 25.0}) {
    SymmetricGroup group(spring_law(1e7, friction * degree));
    const GroupMotion motion = run(group);
    print(motion, friction, HS_STIFFNESS_PER_CONTACT);
    CHECK(motion.asymmetry == 0);
    CHECK(motion.gable.x > 3.01);  // the gables have been hit, and pushed apart
  }
}

/// Pressures and potentials are summed over the corners of what two blocks share, counter-clockwise: a mirror
/// image goes the other way round and rounds otherwise. What that comes to is known from the same motion with
/// one gable shifted by a little: collisions make a difference grow by so many times, and rounding of each
/// step, of coordinates of up to 10 m, is such a difference.
TEST_CASE("B4.2 per area and by potentials a mirror-symmetric group moves symmetrically but for rounding") {
  for (double friction : {0.0, 25.0}) {
    for (int32_t kind : {HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
      hs_law_def law = kind == HS_STIFFNESS_POTENTIAL ? potential_law(1e7, friction * degree)
                                                      : spring_law(1e7, friction * degree);
      law.stiffness_kind = kind;
      SymmetricGroup group(law), shifted(law);
      constexpr double shift = 1e-9;
      const hs_block gable = shifted.pairs[2].first;
      const Point p = shifted.scene.position(gable);
      const hs_pose pose = pose_at(p.x + shift, p.y);
      shifted.scene.check(hs_world_set_pose(shifted.scene.world(), gable, &pose));
      const GroupMotion motion = run(group);
      const double growth = run(shifted).asymmetry / shift;
      print(motion, friction, kind);
      std::printf("B4.2 friction %2.0f deg: a shift of the gable grows %.1f times\n", friction, growth);
      CHECK(motion.asymmetry <= growth * 10000 * 10 * rounding);
      CHECK(std::abs(motion.gable.x - 3) > 0.01);  // the gables have been hit, and thrown aside
    }
  }
}

/// B5.2. Two triangles with an angle of 5 degrees, each the other turned by half a turn about the origin, at
/// +-1 m/s. Their faces are parallel as long as both turn alike. With the offset of 0.45 m only the two tips
/// meet. The force per area is that behind the edge of one of the two blocks, and not symmetric as long
/// as they turn.
struct Triangles {
  double offset;
  double turned;
};

void check_triangles(const Triangles& t, int32_t stiffness_kind) {
  constexpr int steps = 10000;
  hs_world_def def = world_def(2e-5, 0);
  def.potential_length = 1;
  hs_law_def law = spring_law(5e7);
  law.stiffness_kind = stiffness_kind;
  Scene scene(def, law);
  const double c = std::cos(t.turned * degree), s = std::sin(t.turned * degree);
  Points upper{
      {-0.5 + t.offset, 0.02}, {0.5 + t.offset, 0.02}, {-0.5 + t.offset, 0.02 + std::tan(5 * degree)}};
  for (Point& p : upper) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  Points lower = upper;
  for (Point& p : lower) p = {-p.x, -p.y};
  const hs_block up = scene.add(lower, {HS_BLOCK_RIGID, {-s, c}, 0});
  const hs_block down = scene.add(upper, {HS_BLOCK_RIGID, {s, -c}, 0});
  double place = 0, velocity = 0, turn = 0, spin = 0;
  for (int i = 0; i < steps; ++i) {
    scene.step();
    const hs_block_state a = scene.state(up), b = scene.state(down);
    for (int k = 0; k < 2; ++k) {
      place = std::max(place, std::abs(a.pose.position[k] + b.pose.position[k]));
      velocity = std::max(velocity, std::abs(a.velocity[k] + b.velocity[k]));
    }
    turn = std::max(turn, std::abs(a.angle - b.angle));
    spin = std::max(spin, std::abs(a.angular_velocity[2] - b.angular_velocity[2]));
  }
  const hs_block_state a = scene.state(up);
  std::printf(
      "B5.2 %s, offset %5.2f m, scene turned by %2.0f deg: velocity %.4f, %.4f m/s, spin %.4f /s; asymmetry "
      "of place %.1e m, velocity %.1e m/s, turn %.1e, spin %.1e /s\n",
      name_of_stiffness(stiffness_kind), t.offset, t.turned, c * a.velocity[0] + s * a.velocity[1],
      -s * a.velocity[0] + c * a.velocity[1], a.angular_velocity[2], place, velocity, turn, spin);
  CHECK(std::abs(a.angular_velocity[2]) > 0.1);  // they have met, off their centroids
  // Action is reaction: each step rounds velocities and places of about 1 by 1e-16. A contact point known to
  // 2e-16 m gives the spin m / I (24 to 36 per m^2) times that for each 1 m/s that the contact changes.
  CHECK(place <= steps * rounding);
  CHECK(velocity <= steps * rounding);
  CHECK(spin <= 36 * steps * rounding);
  CHECK(turn <= 36 * 0.2 * steps * rounding);
}

TEST_CASE("B5.2 two triangles with an angle of 5 degrees move point-symmetrically") {
  for (int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_POTENTIAL}) {
    for (double offset : {-0.45, -0.25, 0.0, 0.25})
      for (double turned : {0.0, 37.0}) check_triangles({offset, turned}, kind);
  }
}

}  // namespace
