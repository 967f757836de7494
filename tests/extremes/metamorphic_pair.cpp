// Detection where no answer is known: a change of the scene that must not change the answer, or change it in
// a known way.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "catch.h"
#include "extremes/scenes.h"

namespace halfspace_test {
namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr int scenes_of_a_family = 400;

/// Two evaluations of the same gap differ by no more than the rounding of both (rounding_bound,
/// exact_pair.h).
double two_roundings(const Scene& scene) { return 2 * rounding_bound * unit_roundoff * scene.extent(); }

/// The verdicts and gaps of one scene, evaluated in two ways that differ by rounding up to `bound`.
void check_same_to_rounding(const Scene& scene, const hs_contact& one, const hs_contact& other,
                            double bound) {
  const long double exact = exact_verdict(scene.placed_a(), scene.placed_b()).largest_gap;
  INFO(name_of(scene.family) << ": exact gap " << double(exact) << ", found " << one.gap << " and "
                             << other.gap);
  if (std::abs(exact) > bound) CHECK(touches(one) == touches(other));
  const bool comparable = touches(one) && one.type == other.type && one.type != HS_CONTACT_VERTEX_VERTEX;
  if (comparable) CHECK(std::abs(one.gap - other.gap) <= bound);
}

Points renumbered(Points points, std::size_t first, bool reversed) {
  std::rotate(points.begin(), points.begin() + std::ptrdiff_t(first % points.size()), points.end());
  if (reversed) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

TEST_CASE("swapping the blocks turns the normal and keeps the gap") {
  long exact_swaps = 0;
  for_each_scene(scenes_of_a_family, 100, [&](const Scene& s, Random&) {
    const hs_contact forward = detect(s);
    const hs_contact backward = detect(s.b.get(), s.poses.b, s.a.get(), s.poses.a);
    check_same_to_rounding(s, forward, backward, two_roundings(s));

    const bool unturned = s.poses.a.rotation[2] == 0 && s.poses.b.rotation[2] == 0;
    if (unturned)
      CHECK(touches(forward) ==
            touches(backward));  // the same frame both times: the same operations, up to sign
    const bool same_pair = touches(forward) && touches(backward) &&
                           forward.pair_kind == 1 - backward.pair_kind &&
                           forward.feature_a == backward.feature_b && forward.feature_b == backward.feature_a;
    if (!same_pair) return;  // two pairs of the same depth: either may be named
    CHECK(forward.type == backward.type);
    if (unturned) {
      CHECK(forward.gap == backward.gap);
      ++exact_swaps;
    }
    for (int i = 0; i < 2; ++i) {
      // A turned unit vector, 20 roundings each (exact_pair.h), or nothing at all.
      const double bound = unturned ? 0 : 40 * unit_roundoff;
      CHECK(std::abs(forward.normal[i] + backward.normal[i]) <= bound);
    }
  });
  std::printf("swaps in one frame, bit for bit: %ld\n", exact_swaps);
  CHECK(exact_swaps > 100);
}

TEST_CASE("renumbering and reversing the vertices changes nothing but rounding") {
  for_each_scene(scenes_of_a_family, 200, [](const Scene& s, Random& random) {
    const bool reversed = random() % 2 == 0;
    const Shape a = make_shape(s.context, renumbered(s.polygons.a, random() % 64, reversed));
    const Shape b = make_shape(s.context, renumbered(s.polygons.b, random() % 64, !reversed));
    // The centroid, a sum in another order, is elsewhere by rounding: the pose follows it, so that the
    // vertices stay.
    const auto followed = [](hs_pose pose, const hs_shape* from, const hs_shape* to) {
      const hs_shape_properties p = properties_of(from), q = properties_of(to);
      const double dx = q.centroid[0] - p.centroid[0], dy = q.centroid[1] - p.centroid[1];
      const double z = pose.rotation[2], w = pose.rotation[3], d = z * z + w * w;
      const double c = (w * w - z * z) / d, sine = 2 * w * z / d;
      pose.position[0] += c * dx - sine * dy;
      pose.position[1] += sine * dx + c * dy;
      return pose;
    };
    const hs_pose pose_a = followed(s.poses.a, s.a.get(), a.get());
    const hs_pose pose_b = followed(s.poses.b, s.b.get(), b.get());
    double magnitude = 0;  // a position is rounded once more when it follows
    for (const hs_pose& p : {pose_a, pose_b}) magnitude += std::abs(p.position[0]) + std::abs(p.position[1]);
    check_same_to_rounding(s, detect(s), detect(a.get(), pose_a, b.get(), pose_b),
                           two_roundings(s) + 4 * unit_roundoff * magnitude);
  });
}

TEST_CASE("turning both blocks together turns the answer") {
  for_each_scene(scenes_of_a_family, 300, [](const Scene& s, Random& random) {
    const double half = std::uniform_real_distribution<double>(-3, 3)(random);
    const double c = std::cos(2 * half), sine = std::sin(2 * half);
    double magnitude = 0;
    const auto turned = [&](const hs_pose& p) {
      const double x = p.position[0], y = p.position[1], z = p.rotation[2], w = p.rotation[3];
      magnitude += std::abs(x) + std::abs(y);
      return pose_at(c * x - sine * y, sine * x + c * y, std::sin(half) * w + std::cos(half) * z,
                     std::cos(half) * w - std::sin(half) * z);
    };
    const hs_pose pose_a = turned(s.poses.a), pose_b = turned(s.poses.b);
    // The test's own rounding: each quaternion by 4 roundings, so each block turns by 8 of them times its
    // radius and the common turn differs from the positions' by 8 more; each position by 4 roundings of its
    // magnitude.
    const double bound = two_roundings(s) + unit_roundoff * (16 * s.extent() + 4 * magnitude);
    check_same_to_rounding(s, detect(s), detect(s.a.get(), pose_a, s.b.get(), pose_b), bound);
  });
}

TEST_CASE("moving both blocks 1e8 sizes away changes no bit") {
  constexpr double away = 0x1p27;  // 1.3e8
  for_each_scene(scenes_of_a_family, 400, [](const Scene& s, Random&) {
    if (s.family == Family::size_ratio) return;  // its positions reach 1e6: the grid below would not be exact
    const auto on_grid = [](hs_pose p) {         // of 2^-22, so that moving it by 2^27 is exact
      for (int i = 0; i < 2; ++i)
        p.position[i] = std::ldexp(std::round(std::ldexp(std::fmod(p.position[i], 8), 22)), -22);
      return p;
    };
    const auto moved = [](hs_pose p) {
      p.position[0] += away;
      p.position[1] -= away;
      return p;
    };
    const hs_pose pose_a = on_grid(s.poses.a), pose_b = on_grid(s.poses.b);
    const hs_contact here = detect(s.a.get(), pose_a, s.b.get(), pose_b);
    hs_contact there = detect(s.a.get(), moved(pose_a), s.b.get(), moved(pose_b));
    // Only where the points are said to be is rounded, to doubles of that size.
    const auto check_moved = [&](const double* from, const double* to) {
      CHECK(std::abs(to[0] - away - from[0]) <= away * 0x1p-52);
      CHECK(std::abs(to[1] + away - from[1]) <= away * 0x1p-52);
    };
    for (int i = 0; i < here.point_count; ++i) check_moved(here.points[i], there.points[i]);
    if (touches(here)) check_moved(here.center, there.center);
    std::memcpy(there.points, here.points, sizeof there.points);
    std::memcpy(there.center, here.center, sizeof there.center);
    std::memcpy(there.force_point, here.force_point, sizeof there.force_point);
    CHECK(same_bytes(here, there));
  });
}

TEST_CASE("scaling by 2^k scales the answer bit for bit, k = -100..100") {
  long compared = 0;
  for_each_scene(20, 500, [&](const Scene& s, Random&) {
    const hs_contact plain = detect(s);
    const hs_shape_properties whole = properties_of(s.a.get());
    for (int k = -100; k <= 100; ++k) {
      const auto scaled = [k](Points points) {
        for (Point& p : points) p = {std::ldexp(p.x, k), std::ldexp(p.y, k)};
        return points;
      };
      const auto scaled_pose = [k](hs_pose p) {
        for (double& x : p.position) x = std::ldexp(x, k);
        return p;
      };
      const Shape a = make_shape(s.context, scaled(s.polygons.a));
      const Shape b = make_shape(s.context, scaled(s.polygons.b));
      const hs_contact found = detect(a.get(), scaled_pose(s.poses.a), b.get(), scaled_pose(s.poses.b));
      hs_contact expected = plain;
      expected.gap = std::ldexp(plain.gap, k);
      expected.area = std::ldexp(plain.area, k);  // length times unit thickness
      expected.length = std::ldexp(plain.length, k);
      expected.center_gap = std::ldexp(plain.center_gap, k);
      for (int i = 0; i < 2; ++i) {
        expected.gaps[i] = std::ldexp(plain.gaps[i], k);
        for (int d = 0; d < 3; ++d) expected.points[i][d] = std::ldexp(plain.points[i][d], k);
      }
      for (int d = 0; d < 3; ++d) {
        expected.center[d] = std::ldexp(plain.center[d], k);
        expected.force_point[d] = std::ldexp(plain.force_point[d], k);
      }
      INFO(name_of(s.family) << ", k = " << k);
      CHECK(same_bytes(found, expected));

      const hs_shape_properties properties = properties_of(a.get());
      CHECK(properties.volume == std::ldexp(whole.volume, 2 * k));
      for (int i = 0; i < 6; ++i)
        CHECK(properties.second_moment[i] == std::ldexp(whole.second_moment[i], 4 * k));
      ++compared;
    }
  });
  std::printf("scaled pairs compared bit for bit: %ld\n", compared);
}

TEST_CASE("a batch says what single pairs say, bit for bit") {
  const Context context = make_context();
  Random random(600);
  std::vector<Shape> owners;
  std::vector<const hs_shape*> shapes;
  std::vector<hs_pose> poses;
  while (shapes.size() < 60) {
    const PolygonPair polygons = draw_polygons(all_families[random() % 4], random);
    Shape shape = try_shape(context.get(), polygons.a);
    if (!shape) continue;
    const auto anywhere = [&] { return std::uniform_real_distribution<double>(-4, 4)(random); };
    const double half = anywhere();
    poses.push_back(pose_at(anywhere(), anywhere(), std::sin(half), std::cos(half)));
    shapes.push_back(shape.get());
    owners.push_back(std::move(shape));
  }
  const int bodies = int(shapes.size());
  std::vector<std::int32_t> pairs;
  for (int a = 0; a < bodies; ++a) {
    for (int b = 0; b < bodies; ++b) pairs.insert(pairs.end(), {a, b});  // also each with itself
  }
  const std::size_t count = pairs.size() / 2;
  std::vector<hs_pair_cache> batch_caches(count), single_caches(count);
  std::vector<hs_contact> contacts(count);
  for (int round = 0; round < 3; ++round) {  // cold, warm, warm after all have moved
    std::int64_t touching = -1;
    contacts.assign(count, {});  // what a contact does not say is left as it was
    REQUIRE(hs_pairs_detect(context.get(), shapes.data(), poses.data(), bodies, pairs.data(),
                            std::int64_t(count), nullptr, batch_caches.data(), contacts.data(),
                            &touching) == HS_OK);
    std::int64_t counted = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t a = std::size_t(pairs[2 * i]), b = std::size_t(pairs[2 * i + 1]);
      const hs_contact single = detect(shapes[a], poses[a], shapes[b], poses[b], &single_caches[i]);
      CHECK(same_bytes(single, contacts[i]));
      CHECK(std::memcmp(&single_caches[i], &batch_caches[i], sizeof(hs_pair_cache)) == 0);
      counted += touches(single);
    }
    CHECK(touching == counted);
    CHECK(touching > bodies);
    if (round == 1) {
      for (hs_pose& p : poses) p.position[0] *= 0.98;
    }
  }
}

}  // namespace halfspace_test
