// Detection in space where no answer is known: what the vertices themselves say of it, and how answers must
// be related.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "capi/polyhedra.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// The least distance along the contact's normal between any vertex of a and any of b.
double gap_along_normal(const hs_contact& c, const Points3& a, const Points3& b) {
  const Point3 n = vector_of(c.normal);
  double of_a = -HUGE_VAL, of_b = HUGE_VAL;
  for (const Point3& v : a) of_a = std::max(of_a, dot(n, v));
  for (const Point3& v : b) of_b = std::min(of_b, dot(n, v));
  return of_b - of_a;
}

struct Pair {
  Shape a, b;
  hs_pose at_a, at_b;

  hs_contact detect(hs_pair_cache* cache = nullptr) const {
    return detect_pair(a.get(), at_a, b.get(), at_b, cache);
  }
  hs_contact detect_swapped() const { return detect_pair(b.get(), at_b, a.get(), at_a); }
};

/// Two hulls of points on spheres, near each other.
Pair random_pair(hs_context* context, Random& random) {
  constexpr int counts[] = {4, 6, 8, 12, 32, 60};
  Pair pair{make_hull(context, round_points(random, counts[random() % 6])),
            make_hull(context, round_points(random, counts[random() % 6], 0.7)),
            {},
            {}};
  // One draw to a statement: the order within an expression is the compiler's.
  const auto turned_at = [&](const Point3& position) {
    const Point3 axis = random_direction(random);
    return pose_at(position, axis, uniform_between(random, -3, 3));
  };
  const double distance = uniform_between(random, 0.6, 2);
  const Point3 apart = distance * random_direction(random);
  const Point3 at = {uniform_between(random, -5, 5), uniform_between(random, -5, 5), 3};
  pair.at_a = turned_at(at);
  pair.at_b = turned_at(at + apart);
  return pair;
}

/// Rounding of gaps and points of random_pair(): some 50 operations on numbers up to 10.
constexpr double rounding = 500 * 0x1p-53;

/// The gap of a contact with a region is that of its deepest point; the vertex may lie deeper beyond the
/// region's border, by the slope of up to fifteen times the parallel angle over the blocks' diameter of up
/// to 2.
constexpr double beyond_region = 15 * 0.01 * 2;

bool has_region(const hs_contact& c) {
  return c.type == HS_CONTACT_FACE_FACE || c.type == HS_CONTACT_EDGE_FACE;
}

}  // namespace

TEST_CASE("in space, every answer is what its normal shows of the vertices") {
  const Context context = make_context();
  Random random(11);
  long of_type[7] = {}, of_kind[4] = {};
  for (int i = 0; i < 2000; ++i) {
    const Pair pair = random_pair(context.get(), random);
    const hs_contact c = pair.detect();
    ++of_type[c.type];
    ++of_kind[c.pair_kind];
    CHECK(length(vector_of(c.normal)) == Approx(1).epsilon(1e-14));
    const double gap = gap_along_normal(c, placed(pair.a.get(), pair.at_a), placed(pair.b.get(), pair.at_b));
    if (c.type == HS_CONTACT_NONE) {
      CHECK(c.gap > 0);
      CHECK(std::abs(c.gap - gap) <= rounding);
      if (c.pair_kind == HS_PAIR_FACE_VERTEX) CHECK((c.feature_a >= 0 && c.feature_b == -1));
      if (c.pair_kind == HS_PAIR_VERTEX_FACE) CHECK((c.feature_a == -1 && c.feature_b >= 0));
    } else {
      // Of a contact without history the pair is that of least depth. Along the sum of several normals, at a
      // corner, the blocks overlap by more than their vertices' distance there, never less.
      CHECK(gap <= c.gap + rounding);
      if (c.type == HS_CONTACT_VERTEX_FACE || c.type == HS_CONTACT_EDGE_EDGE)
        CHECK(std::abs(c.gap - gap) <= rounding);
      if (has_region(c)) CHECK(c.gap - gap <= beyond_region + rounding);
      CHECK((c.feature_a >= 0 && c.feature_b >= 0));
    }
  }
  std::printf("contacts in space: none %ld, edge-edge %ld, vertex-face %ld; pairs %ld %ld %ld %ld\n",
              of_type[HS_CONTACT_NONE], of_type[HS_CONTACT_EDGE_EDGE], of_type[HS_CONTACT_VERTEX_FACE],
              of_kind[0], of_kind[1], of_kind[2], of_kind[3]);
  for (int type : {HS_CONTACT_NONE, HS_CONTACT_EDGE_EDGE, HS_CONTACT_VERTEX_FACE}) CHECK(of_type[type] > 100);
  for (long n : of_kind) CHECK(n > 50);
}

TEST_CASE("in space, swapping the blocks turns the normal and keeps the gap") {
  const Context context = make_context();
  Random random(12);
  long compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pair pair = random_pair(context.get(), random);
    const hs_contact forward = pair.detect(), backward = pair.detect_swapped();
    const bool near_touching = std::min(std::abs(forward.gap), std::abs(backward.gap)) <= rounding;
    if (near_touching) continue;
    REQUIRE((forward.type == HS_CONTACT_NONE) == (backward.type == HS_CONTACT_NONE));
    if (forward.type == HS_CONTACT_NONE) continue;  // any plane between is a proof
    if (length(vector_of(forward.normal) + vector_of(backward.normal)) > 1e-9) {
      CHECK(std::abs(forward.gap - backward.gap) <= beyond_region);  // two pairs of one depth
      continue;
    }
    ++compared;
    CHECK(forward.type == backward.type);
    CHECK(std::abs(forward.gap - backward.gap) <= rounding);
    CHECK(std::abs(forward.area - backward.area) <= rounding);
    CHECK(length(vector_of(forward.center) - vector_of(backward.center)) <=
          std::abs(forward.gap) + 1e-9);  // on the plane of the one or of the other
    const std::int32_t swapped[] = {HS_PAIR_VERTEX_FACE, HS_PAIR_FACE_VERTEX, HS_PAIR_EDGE_EDGE};
    if (forward.pair_kind == swapped[backward.pair_kind]) {
      CHECK(forward.feature_a == backward.feature_b);
      CHECK(forward.feature_b == backward.feature_a);
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("in space, a pair that moves in small steps is judged as if it had no past") {
  const Context context = make_context();
  Random random(13);
  long steps = 0, touching = 0, changes = 0, by_proof = 0;
  for (int i = 0; i < 60; ++i) {
    Pair pair = random_pair(context.get(), random);
    // b passes through a and turns meanwhile.
    const Point3 middle = vector_of(pair.at_a.position), heading = random_direction(random);
    const Point3 aside = 0.8 * random_direction(random), axis = random_direction(random);
    hs_pair_cache cache{};
    bool touched = false;
    for (int k = -300; k <= 300; ++k, ++steps) {
      pair.at_b = pose_at(middle + aside + (k / 100.0) * heading, axis, k / 150.0);
      const hs_pair_cache before = cache;
      const hs_contact warm = pair.detect(&cache), cold = pair.detect();
      const bool touches = warm.type != HS_CONTACT_NONE;
      by_proof += !touches && std::memcmp(&before, &cache, sizeof cache) == 0;
      const double gap =
          gap_along_normal(warm, placed(pair.a.get(), pair.at_a), placed(pair.b.get(), pair.at_b));
      if (std::abs(cold.gap) > rounding) CHECK(touches == (cold.type != HS_CONTACT_NONE));
      if (touches) {
        CHECK(gap <= warm.gap + rounding);
        // The pair that the blocks met through may be deeper than the least deep, not shallower; but for the
        // depth at a corner, which is along another normal.
        if (cold.type == HS_CONTACT_VERTEX_FACE && warm.type == HS_CONTACT_VERTEX_FACE)
          CHECK(warm.gap <= cold.gap + rounding);
      } else {
        CHECK(warm.gap > 0);
        CHECK(warm.gap <= gap + rounding);  // what motion can have taken is more than what it has
      }
      touching += touches;
      changes += touches != touched;
      touched = touches;
    }
  }
  std::printf("coherent steps in space %ld, touching %ld, changes of verdict %ld, by the proof alone %ld\n",
              steps, touching, changes, by_proof);
  CHECK(touching > steps / 10);
  CHECK(changes > 60);
  CHECK(by_proof > steps / 10);
}

TEST_CASE("in space, no cache content, however stale, changes the verdict") {
  const Context context = make_context();
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    const Pair pair = random_pair(context.get(), random);
    const hs_shape_properties a = properties_of(pair.a.get()), b = properties_of(pair.b.get());
    const std::int32_t state = 1 + std::int32_t(random() % 2);
    const std::int32_t kind = std::int32_t(random() % (state == 1 ? 4 : 3));
    const std::int64_t of_a[] = {a.face_count, a.vertex_count, a.edge_count, a.vertex_count};
    const std::int64_t of_b[] = {b.vertex_count, b.face_count, b.edge_count, b.vertex_count};
    hs_pair_cache cache = cache_of(state, kind, std::int32_t(random() % std::uint64_t(of_a[kind])),
                                   std::int32_t(random() % std::uint64_t(of_b[kind])));
    const hs_contact cold = pair.detect(), warm = pair.detect(&cache);
    if (std::abs(cold.gap) > rounding)
      CHECK((warm.type == HS_CONTACT_NONE) == (cold.type == HS_CONTACT_NONE));
  }
}

TEST_CASE("a batch of both dimensions says what single pairs say, bit for bit") {
  const Context context = make_context();
  Random random(15);
  std::vector<Shape> owners;
  std::vector<const hs_shape*> shapes;
  std::vector<hs_pose> poses;
  for (int i = 0; i < 30; ++i) {
    const Point3 at = {uniform_between(random, -2, 2), uniform_between(random, -2, 2),
                       uniform_between(random, -2, 2)};
    owners.push_back(i % 3 == 0 ? make_shape(context.get(), box(-1, -0.5, 1, 0.5))
                                : make_hull(context.get(), round_points(random, 4 + 3 * i)));
    poses.push_back(i % 3 == 0 ? pose_at(at.x, at.y) : pose_at(at, random_direction(random), at.x));
    shapes.push_back(owners.back().get());
  }
  std::vector<std::int32_t> pairs;
  for (int a = 0; a < 30; ++a) {
    for (int b = 0; b < 30; ++b) {
      if ((a % 3 == 0) == (b % 3 == 0)) pairs.insert(pairs.end(), {a, b});
    }
  }
  const std::size_t count = pairs.size() / 2;
  std::vector<hs_pair_cache> batch_caches(count), single_caches(count);
  for (int round = 0; round < 3; ++round) {  // cold, warm, warm after all have moved
    std::vector<hs_contact> contacts(count);
    std::int64_t touching = -1;
    REQUIRE(hs_pairs_detect(context.get(), shapes.data(), poses.data(), 30, pairs.data(), std::int64_t(count),
                            nullptr, batch_caches.data(), contacts.data(), &touching) == HS_OK);
    std::int64_t counted = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t a = std::size_t(pairs[2 * i]), b = std::size_t(pairs[2 * i + 1]);
      const hs_contact single = detect_pair(shapes[a], poses[a], shapes[b], poses[b], &single_caches[i]);
      CHECK(std::memcmp(&single, &contacts[i], sizeof single) == 0);
      CHECK(std::memcmp(&single_caches[i], &batch_caches[i], sizeof(hs_pair_cache)) == 0);
      counted += single.type != HS_CONTACT_NONE;
    }
    CHECK(touching == counted);
    CHECK(touching > 30);
    if (round == 1) {
      for (hs_pose& p : poses) p.position[0] *= 0.98;
    }
  }
}

TEST_CASE("a polyhedron may be moved 1e8 sizes away, and pairs scaled by 2^k, without a changed bit") {
  const Context context = make_context();
  Random random(16);
  for (int i = 0; i < 200; ++i) {
    Pair pair = random_pair(context.get(), random);
    for (hs_pose* p : {&pair.at_a, &pair.at_b})  // on a grid on which the move is exact
      for (double& x : p->position) x = std::ldexp(std::round(std::ldexp(x, 22)), -22);
    const hs_contact here = pair.detect();
    Pair far{nullptr, nullptr, pair.at_a, pair.at_b};
    for (hs_pose* p : {&far.at_a, &far.at_b}) p->position[2] += 0x1p27;
    const hs_contact there = detect_pair(pair.a.get(), far.at_a, pair.b.get(), far.at_b);
    CHECK(there.type == here.type);
    CHECK(there.gap == here.gap);
    CHECK(std::memcmp(there.normal, here.normal, sizeof here.normal) == 0);

    for (int k : {-60, 7, 60}) {
      const auto scaled = [k](const hs_shape* shape) {
        Points3 points = vertices_3d_of(shape);
        for (Point3& p : points) p = {std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
        return points;
      };
      const auto placed_scaled = [k](hs_pose p) {
        for (double& x : p.position) x = std::ldexp(x, k);
        return p;
      };
      // Hulls of the vertices as they come back, at both sizes: those were rounded once on the way.
      const Shape a = make_hull(context.get(), vertices_3d_of(pair.a.get()));
      const Shape b = make_hull(context.get(), vertices_3d_of(pair.b.get()));
      const Shape large_a = make_hull(context.get(), scaled(pair.a.get()));
      const Shape large_b = make_hull(context.get(), scaled(pair.b.get()));
      const hs_contact plain = detect_pair(a.get(), pair.at_a, b.get(), pair.at_b);
      const hs_contact large =
          detect_pair(large_a.get(), placed_scaled(pair.at_a), large_b.get(), placed_scaled(pair.at_b));
      CHECK(large.type == plain.type);
      CHECK(large.gap == std::ldexp(plain.gap, k));
      CHECK(large.area == std::ldexp(plain.area, 2 * k));
      CHECK(large.length == std::ldexp(plain.length, k));
      CHECK(std::memcmp(large.normal, plain.normal, sizeof plain.normal) == 0);
      CHECK(large.pair_kind == plain.pair_kind);
      for (int p = 0; p < plain.point_count; ++p)
        for (int d = 0; d < 3; ++d) CHECK(large.points[p][d] == std::ldexp(plain.points[p][d], k));
    }
  }
}

TEST_CASE(
    "in space, a block that is nothing to rounding beside the other has a gap and a place all the same") {
  const Context context = make_context();
  const auto prism = [&](int sides, double size) {
    Points3 points;
    for (int i = 0; i < sides; ++i) {
      const double angle = 6.283185307179586 * i / sides;
      for (const double z : {-size, size})
        points.push_back({size * std::cos(angle), size * std::sin(angle), z});
    }
    return make_hull(context.get(), points);
  };
  const double ways[] = {-1, -0.5, 0, 0.5, 1};
  for (const double size : {1e-12, 1e-15, 1e-16, 1e-17, 1e-20, 1e-25, 1e-33, 1e-40})
    for (const int sides : {3, 8, 40})
      for (const int sides_of_small : {5, 8, 17}) {
        const Shape large = prism(sides, 1), small = prism(sides_of_small, size);
        for (const double x : ways)
          for (const double y : ways)
            for (const double z : ways)
              for (const bool swapped : {false, true}) {
                const hs_pose here = pose_at(0, 0), there = pose_at({x, y, z});
                const hs_contact c = swapped ? detect_pair(small.get(), there, large.get(), here)
                                             : detect_pair(large.get(), here, small.get(), there);
                INFO("size " << size << ", " << sides << " and " << sides_of_small << " sides, at " << x
                             << ' ' << y << ' ' << z);
                CHECK(std::isfinite(c.gap));
                CHECK(length(vector_of(c.normal)) == Approx(1));
                if (c.type == HS_CONTACT_NONE) continue;
                CHECK(std::isfinite(length(vector_of(c.center))));
                CHECK((std::isfinite(c.center_gap) && std::isfinite(c.area) && std::isfinite(c.length)));
              }
      }
}

TEST_CASE(
    "round columns in one another have the least depth of all their sides, whichever of them comes first") {
  const Context context = make_context();
  const auto corners = [](int sides, double radius, double first_angle) {
    Points3 points;
    for (int i = 0; i < sides; ++i) {
      const double angle = first_angle + 6.283185307179586 * i / sides;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return points;
  };
  const auto column = [&](const Points3& outline, double half_height) {
    Points3 points;
    for (const Point3& p : outline)
      for (const double z : {-half_height, half_height}) points.push_back({p.x, p.y, z});
    return make_hull(context.get(), points);
  };
  const auto reach = [](const Points3& outline, const Point3& along) {
    double farthest = 0;
    for (const Point3& p : outline) farthest = std::max(farthest, dot(along, p));
    return farthest;
  };
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const int sides_of_a = 20 + int(random() % 60), sides_of_b = 20 + int(random() % 60);
    const double turn_of_a = uniform_between(random, 0, 1), turn_of_b = uniform_between(random, 0, 1);
    const Points3 of_a = corners(sides_of_a, 0.7, turn_of_a), of_b = corners(sides_of_b, 0.77, turn_of_b);
    double min_depth = HUGE_VAL;  // across the middle of a side of either
    for (const auto& [sides, turn] : {std::pair(sides_of_a, turn_of_a), std::pair(sides_of_b, turn_of_b)})
      for (int side = 0; side < sides; ++side) {
        const double angle = turn + 6.283185307179586 * (side + 0.5) / sides;
        for (const double sense : {1.0, -1.0}) {
          const Point3 n{sense * std::cos(angle), sense * std::sin(angle), 0};
          min_depth = std::min(min_depth, reach(of_a, n) + reach(of_b, {-n.x, -n.y, 0}));
        }
      }
    const Pair pair{column(of_a, 2), column(of_b, 3), pose_at(0, 0), pose_at(0, 0)};
    INFO(sides_of_a << " and " << sides_of_b << " sides");
    CHECK(-pair.detect().gap == Approx(min_depth).epsilon(1e-12));
    CHECK(-pair.detect_swapped().gap == Approx(min_depth).epsilon(1e-12));
  }
}

}  // namespace halfspace_test
