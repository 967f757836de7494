#include "simd/four_lanes.h"

#include <algorithm>
#include <array>
#include <vector>

#include "catch.h"
#include "narrow_phase/space/epa.h"
#include "narrow_phase/space/support.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// What is found with either make of lanes. Checks nothing where the processor has no AVX2.
template <class Work>
void check_same_with_both(const Work& work) {
  const auto by_two = work.template operator()<TwiceTwoLanes>();
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) CHECK(with_avx2(work) == by_two);
#endif
}

/// The depths that a polytope comes to as it takes in points.
template <class Four>
[[gnu::always_inline]] inline std::vector<double> depths(const Cloud& points) {
  std::vector<double> depths;
  Corner first[4];
  for (int i = 0; i < 4; ++i) first[i] = {points[std::size_t(i)], i, i};
  ExpandingPolytope<Four> polytope(first);
  for (int i = 4; i < int(points.size()); ++i) {
    polytope.expand({points[std::size_t(i)], i, i});
    depths.push_back(polytope.nearest().offset);
    for (int c = 0; c < 3; ++c) depths.push_back(polytope.nearest().normal[c]);
  }
  return depths;
}

}  // namespace

TEST_CASE("four lanes are compared, turned over and summed as their numbers are") {
  const double a[] = {1, -2, 3, -0.0}, b[] = {-1, 5, 3, 0.5};
  check_same_with_both([&]<class Four>() {
    const Four p = load_four<Four>(a), q = load_four<Four>(b);
    const Four most = max(p, q), least = min(p, q), sizes = abs(p);
    for (int i = 0; i < 4; ++i) {
      CHECK(most[i] == std::max(a[i], b[i]));
      CHECK(least[i] == std::min(a[i], b[i]));
      CHECK(sizes[i] == std::abs(a[i]));
      CHECK_FALSE(std::signbit(sizes[i]));
    }
    CHECK(reduce_min(p) == -2);
    CHECK(reduce_max(p) == 3);
    Four rows[] = {p, q, most, least};
    const Four before[] = {p, q, most, least};
    transpose(rows);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) CHECK(rows[i][k] == before[k][i]);
    return reduce(p);
  });
  CHECK(reduce(load_four<TwiceTwoLanes>(b)) == 7.5);
}

TEST_CASE("the deepest vertex is the same whatever the lanes") {
  Random random(1);
  for (const int points : {4, 5, 8, 9, 12, 48, 128}) {
    const Shape<3> shape = shape_of(hull_of(random_cloud(random, points, 0.9, 1)));
    for (int i = 0; i < 100; ++i) {
      const Vector<3> direction = random_direction(random);
      check_same_with_both([&]<class Four>() {
        const Support deepest = deepest_among_all<Four>(shape.outline(), direction);
        return std::pair(deepest.height, deepest.vertex);
      });
    }
  }
}

TEST_CASE("a polytope expands to the same bits whatever the lanes") {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    Cloud points = {{-0.1, -0.1, -0.1}, {0.3, 0, 0}, {0, 0.3, 0}, {0, 0, 0.3}};
    for (const Vector<3>& p : random_cloud(random, 40, 0.5, 1)) points.push_back(p);
    check_same_with_both([&]<class Four>() { return depths<Four>(points); });
  }
}
