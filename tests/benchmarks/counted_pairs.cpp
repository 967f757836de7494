#include "counted_pairs.h"

#include <cmath>

#include "random_polygon.h"
#include "random_polyhedron.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;
using halfspace_test::Shape;

/// Blocks have a diameter of 1, in the plane 3 to 8 vertices, in space 12 to 20.
Shape random_shape(hs_context* context, int dimension, Random& random) {
  if (dimension == 3) return hull(context, random_corners(random));
  return halfspace_test::make_shape(context, random_polygon(3 + int(random() % 6), 0.5, random));
}

}  // namespace

CountedPairs::CountedPairs(hs_context* context, int dimension, int count) : context_(context) {
  Random random(1);
  const hs_pose origin{{0, 0, 0}, {0, 0, 0, 1}};
  while (int(pairs_.size()) < count) {
    pairs_.push_back({random_shape(context, dimension, random),
                      random_shape(context, dimension, random),
                      origin,
                      origin,
                      {}});
    Pair& pair = pairs_.back();
    double gap = 0;
    do {
      const double distance = uniform(random, 0.5, 1), angle = uniform(random, -pi, pi);
      pair.pose_b.position[0] = distance * std::cos(angle);
      pair.pose_b.position[dimension - 1] = distance * std::sin(angle);
      pair.cache = {};
      gap = contact_of(pair).gap;
    } while (gap < -0.05 || gap > -0.005);
  }
}

void CountedPairs::detect() {
  shift_ = -shift_;
  for (Pair& pair : pairs_) {
    pair.pose_b.position[0] += shift_;
    contact_of(pair);
  }
}

hs_contact CountedPairs::contact_of(Pair& pair) const {
  hs_contact contact;
  require_ok(
      hs_pair_detect(pair.a.get(), &pair.pose_a, pair.b.get(), &pair.pose_b, nullptr, &pair.cache, &contact),
      context_);
  return contact;
}

}  // namespace halfspace_benchmark
