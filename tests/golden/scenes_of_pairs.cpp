#include "golden/stage.h"

// Single pairs, without a world: detection with and without a cache, and times of impact.

namespace halfspace_test {
namespace {

Shape random_shape(Random& random, hs_context* context, int dimension, int corners) {
  return dimension == 2 ? make_shape(context, random_round_polygon(random, corners, 1))
                        : make_hull(context, random_round_points(random, corners, 1));
}

hs_pose random_pose(Random& random, int dimension, double reach) {
  const Point3 position = {number_between(random, -reach, reach), number_between(random, -reach, reach),
                           number_between(random, -reach, reach)};
  const Point3 axis = {number_between(random, -1, 1), number_between(random, -1, 1),
                       number_between(random, -1, 1)};
  const double turn = number_between(random, -2, 2);
  return dimension == 2 ? turned_pose(Point{position.x, position.y}, turn)
                        : turned_pose(position, axis, turn);
}

std::uint64_t detection(int dimension) {
  const Context context = make_context();
  Random random(5);
  Hash hash;
  for (int i = 0; i < 60; ++i) {
    const Shape a = random_shape(random, context.get(), dimension, 4 + i % 40);
    const Shape b = random_shape(random, context.get(), dimension, 4 + i * 7 % 150);
    hs_pair_cache cache{};
    const hs_pose of_a = random_pose(random, dimension, 1);
    hs_pose of_b = random_pose(random, dimension, 1);
    for (int k = 0; k < 8; ++k) {
      hs_contact contact{};
      require_ok(hs_pair_detect(a.get(), &of_a, b.get(), &of_b, nullptr, nullptr, &contact), context.get());
      record_detected(hash, contact);
      require_ok(hs_pair_detect(a.get(), &of_a, b.get(), &of_b, nullptr, &cache, &contact), context.get());
      record_detected(hash, contact);
      of_b.position[k % dimension] += 0.1;
    }
  }
  return hash.value();
}

std::uint64_t impacts(int dimension) {
  const Context context = make_context();
  Random random(6);
  Hash hash;
  for (int i = 0; i < 100; ++i) {
    const Shape a = random_shape(random, context.get(), dimension, 4 + i % 12);
    const Shape b = random_shape(random, context.get(), dimension, 4 + i * 7 % 12);
    hs_motion_def motions[2];
    for (hs_motion_def& motion : motions) {
      require_ok(hs_motion_def_init(&motion, sizeof motion), context.get());
      motion.start = random_pose(random, dimension, 3);
      // Spins up to the 1e6 rad that are allowed.
      const double spin = i % 10 == 0 ? 5e5 : 20;
      for (int k = 0; k < 3; ++k) {
        motion.velocity[k] = number_between(random, -3, 3);
        motion.angular_velocity[k] = number_between(random, -spin, spin);
      }
      motion.gradient_rate[0] = number_between(random, -0.5, 0.5);
    }
    hs_impact impact{};
    require_ok(hs_pair_time_of_impact(a.get(), &motions[0], b.get(), &motions[1], 1, &impact), context.get());
    record(hash, impact);
  }
  return hash.value();
}

}  // namespace

std::vector<Scene> scenes_of_pairs() {
  std::vector<Scene> scenes;
  for (const int dimension : {2, 3}) {
    const std::string where = dimension == 2 ? "plane: " : "space: ";
    scenes.push_back({where + "random pairs", [=] { return detection(dimension); }});
    scenes.push_back({where + "random impacts", [=] { return impacts(dimension); }});
  }
  return scenes;
}

}  // namespace halfspace_test
