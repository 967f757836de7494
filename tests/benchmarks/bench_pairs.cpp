// Verdict and manifold of one pair: hs_pair_detect (double) against Box2D's b2CollidePolygons (float).
// README.md says what is timed and how to read the figures.

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <cmath>
#include <cstdio>
#include <deque>
#include <stdexcept>

#include "box2d_polygon.h"
#include "convex_pairs.h"
#include "pair_sets.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

struct HalfspacePair {
  const hs_shape* a;
  const hs_shape* b;
  hs_pose at_a;
  hs_pose at_b;
  hs_pair_cache cache;
};

struct Box2dPair {
  const b2PolygonShape* a;
  const b2PolygonShape* b;
  b2Transform at_a;
  b2Transform at_b;
};

/// The pose of a shape's centroid when the coordinates it was made from are placed.
hs_pose pose_of(const hs_shape* shape, const Placement& at) {
  const hs_shape_properties properties = halfspace_test::properties_of(shape);
  const double c = std::cos(at.angle), s = std::sin(at.angle);
  const double x = properties.centroid[0], y = properties.centroid[1];
  return halfspace_test::pose_at(at.position.x + (c * x - s * y), at.position.y + (s * x + c * y),
                                 std::sin(at.angle / 2), std::cos(at.angle / 2));
}

b2Transform transform_of(const Placement& at) {
  return {{float(at.position.x), float(at.position.y)}, b2Rot(float(at.angle))};
}

/// One set of pairs as both engines see it.
struct Arena {
  Arena(const PairSet& set, hs_context* context) {
    for (const Points& polygon : set.polygons) {
      halfspace_shapes.push_back(halfspace_test::make_shape(context, polygon));
      box2d_shapes.push_back(box2d_shape(polygon));
    }
    for (const ConvexPair& pair : set.pairs) {
      const hs_shape* a = halfspace_shapes[std::size_t(pair.a)].get();
      const hs_shape* b = halfspace_shapes[std::size_t(pair.b)].get();
      halfspace.push_back({a, b, pose_of(a, pair.at_a), pose_of(b, pair.at_b), {}});
      box2d.push_back({&box2d_shapes[std::size_t(pair.a)], &box2d_shapes[std::size_t(pair.b)],
                       transform_of(pair.at_a), transform_of(pair.at_b)});
      truth.push_back(separation(set, pair) <= 0);
    }
  }

  std::vector<halfspace_test::Shape> halfspace_shapes;
  std::deque<b2PolygonShape> box2d_shapes;  // a deque: the pairs point into it while it grows
  std::vector<HalfspacePair> halfspace;
  std::vector<Box2dPair> box2d;
  std::vector<bool> truth;
};

bool touches(const HalfspacePair& pair, hs_pair_cache* cache) {
  hs_contact contact;
  const hs_status status = hs_pair_detect(pair.a, &pair.at_a, pair.b, &pair.at_b, nullptr, cache, &contact);
  if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
  return contact.type != HS_CONTACT_NONE;
}

bool touches_cold(HalfspacePair& pair) { return touches(pair, nullptr); }
bool touches_warm(HalfspacePair& pair) { return touches(pair, &pair.cache); }

bool touches_box2d(Box2dPair& pair) {
  b2Manifold manifold;
  b2CollidePolygons(&manifold, pair.a, pair.at_a, pair.b, pair.at_b);
  return manifold.pointCount > 0;
}

/// One engine's way to answer on its pairs: its verdicts judged once, its time taken pass by pass.
template <class Pair>
class Contestant {
 public:
  Contestant(std::vector<Pair>& pairs, bool (*touches)(Pair&), const std::vector<bool>& truth)
      : pairs_(pairs), touches_(touches) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool verdict = touches(pairs[i]);
      touching_ += verdict;
      wrong_ += verdict != truth[i];
    }
  }

  void time_pass(Random& random) {
    std::shuffle(pairs_.begin(), pairs_.end(), random);
    int touching = 0;
    passes_.add(seconds_of([&] {
      for (Pair& pair : pairs_) touching += touches_(pair);
    }));
    if (touching != touching_)
      throw std::runtime_error("the same pairs gave another answer when they were asked again");
  }

  double minimum_ns() const { return 1e9 * passes_.minimum() / double(pairs_.size()); }
  double median_ns() const { return 1e9 * passes_.median() / double(pairs_.size()); }
  int wrong() const { return wrong_; }

 private:
  std::vector<Pair>& pairs_;
  bool (*touches_)(Pair&);
  Passes passes_;
  int touching_ = 0;
  int wrong_ = 0;
};

void run(int vertices, const GapSet& gap, const Sizes& sizes, hs_context* context, Random& random) {
  Arena arena(draw_pairs(sizes.pairs, sizes.shapes, vertices, gap, random), context);
  Contestant cold(arena.halfspace, touches_cold, arena.truth);
  Contestant(arena.halfspace, touches_warm, arena.truth);  // fills the caches
  Contestant warm(arena.halfspace, touches_warm, arena.truth);
  Contestant peer(arena.box2d, touches_box2d, arena.truth);

  for (int pass = 0; pass < passes; ++pass) {
    cold.time_pass(random);
    peer.time_pass(random);
    warm.time_pass(random);
  }

  std::printf("%8d %-6s %7.1f %7.1f %7.1f %7.1f %7.1f %7.1f %9.2f %9.2f %6d %5d %5d\n", vertices, gap.name,
              cold.minimum_ns(), cold.median_ns(), warm.minimum_ns(), warm.median_ns(), peer.minimum_ns(),
              peer.median_ns(), cold.minimum_ns() / peer.minimum_ns(), warm.minimum_ns() / peer.minimum_ns(),
              cold.wrong(), warm.wrong(), peer.wrong());
}

void run_all(const Sizes& sizes) {
  const halfspace_test::Context context = halfspace_test::make_context();
  Random random(1);
  std::printf("%8s %-6s %15s %15s %15s %19s %18s\n", "", "", "hs cold, ns", "hs warm, ns", "Box2D, ns",
              "ratio of minima", "wrong verdicts");
  std::printf("%8s %-6s %7s %7s %7s %7s %7s %7s %9s %9s %6s %5s %5s\n", "vertices", "set", "min", "median",
              "min", "median", "min", "median", "cold", "warm", "cold", "warm", "Box2D");
  for (const int vertices : {3, 4, 6, 8}) {
    for (const GapSet& gap : gap_sets) run(vertices, gap, sizes, context.get(), random);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const Sizes sizes = read_sizes(argc, argv, "bench_pairs");
  if (sizes.shapes < 1) return 2;
  std::printf("libhalfspace %s, Box2D " BOX2D_VERSION "; %d pairs of %d shapes a set, %d passes, core %d\n",
              hs_version(), sizes.pairs, sizes.shapes, passes, pin_to_this_core());
  try {
    run_all(sizes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pairs: %s\n", error.what());
    return 1;
  }
}
