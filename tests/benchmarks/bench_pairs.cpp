// Verdict and manifold of one pair: hs_pair_detect (double) against Box2D's b2CollidePolygons (float).
// README.md says what is timed and how to read the figures.

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <numeric>

#include "convex_pairs.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

constexpr int passes = 7;

struct HalfspacePair {
  halfspace_test::Shape a;
  halfspace_test::Shape b;
  hs_pose at_a;
  hs_pose at_b;
  hs_pair_cache cache;
};

struct Box2dPair {
  b2PolygonShape a;
  b2PolygonShape b;
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

HalfspacePair for_halfspace(hs_context* context, const ConvexPair& pair) {
  HalfspacePair made{};
  made.a = halfspace_test::make_shape(context, pair.a);
  made.b = halfspace_test::make_shape(context, pair.b);
  made.at_a = pose_of(made.a.get(), pair.at_a);
  made.at_b = pose_of(made.b.get(), pair.at_b);
  return made;
}

b2PolygonShape box2d_shape(const Points& polygon) {
  std::vector<b2Vec2> vertices;
  for (const Point& p : polygon) vertices.push_back({float(p.x), float(p.y)});
  b2PolygonShape shape;
  shape.Set(vertices.data(), int32(vertices.size()));
  return shape;
}

Box2dPair for_box2d(const ConvexPair& pair) {
  const auto transform = [](const Placement& at) {
    return b2Transform({float(at.position.x), float(at.position.y)}, b2Rot(float(at.angle)));
  };
  return {box2d_shape(pair.a), box2d_shape(pair.b), transform(pair.at_a), transform(pair.at_b)};
}

bool touches_cold(HalfspacePair& pair) {
  hs_contact contact;
  hs_pair_detect(pair.a.get(), &pair.at_a, pair.b.get(), &pair.at_b, nullptr, nullptr, &contact);
  return contact.type != HS_CONTACT_NONE;
}

bool touches_warm(HalfspacePair& pair) {
  hs_contact contact;
  hs_pair_detect(pair.a.get(), &pair.at_a, pair.b.get(), &pair.at_b, nullptr, &pair.cache, &contact);
  return contact.type != HS_CONTACT_NONE;
}

bool touches_box2d(Box2dPair& pair) {
  b2Manifold manifold;
  b2CollidePolygons(&manifold, &pair.a, pair.at_a, &pair.b, pair.at_b);
  return manifold.pointCount > 0;
}

/// Times one engine's answer on all pairs in the order given; the number of touching pairs keeps the work from being left out.
template <class Pair>
double time_pass(std::vector<Pair>& pairs, const std::vector<int>& order, bool (*touches)(Pair&), int& touching) {
  return seconds_of([&] {
    for (const int i : order) touching += touches(pairs[std::size_t(i)]);
  });
}

template <class Pair>
int count_wrong(std::vector<Pair>& pairs, const std::vector<bool>& truth, bool (*touches)(Pair&)) {
  int wrong = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) wrong += touches(pairs[i]) != truth[i];
  return wrong;
}

void run(int vertices, const GapSet& set, int count, hs_context* context, Random& random) {
  const std::vector<ConvexPair> drawn = draw_pairs(count, vertices, set, random);
  std::vector<HalfspacePair> halfspace;
  std::vector<Box2dPair> box2d;
  std::vector<bool> truth;
  for (const ConvexPair& pair : drawn) {
    halfspace.push_back(for_halfspace(context, pair));
    box2d.push_back(for_box2d(pair));
    truth.push_back(separation(pair) <= 0);
  }
  const int wrong_cold = count_wrong(halfspace, truth, touches_cold);
  count_wrong(halfspace, truth, touches_warm);  // fills the caches
  const int wrong_warm = count_wrong(halfspace, truth, touches_warm);
  const int wrong_box2d = count_wrong(box2d, truth, touches_box2d);

  std::vector<int> order(std::size_t(count));
  std::iota(order.begin(), order.end(), 0);
  Passes cold, warm, peer;
  int touching = 0;
  const auto reshuffled = [&]() -> const std::vector<int>& {
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  for (int pass = 0; pass < passes; ++pass) {
    cold.add(time_pass(halfspace, reshuffled(), touches_cold, touching));
    peer.add(time_pass(box2d, reshuffled(), touches_box2d, touching));
    warm.add(time_pass(halfspace, reshuffled(), touches_warm, touching));
  }

  const auto ns = [&](double seconds) { return 1e9 * seconds / count; };
  std::printf("%8d %-6s %7.1f %7.1f %7.1f %7.1f %7.1f %7.1f %9.2f %9.2f %6d %5d %5d\n", vertices, set.name,
              ns(cold.minimum()), ns(cold.median()), ns(warm.minimum()), ns(warm.median()), ns(peer.minimum()),
              ns(peer.median()), cold.median() / peer.median(), warm.median() / peer.median(), wrong_cold, wrong_warm,
              wrong_box2d);
  if (touching < 0) std::abort();  // never: it only makes the answers matter
}

void run_all(int count) {
  const halfspace_test::Context context = halfspace_test::make_context();
  Random random(1);
  std::printf("%8s %-6s %15s %15s %15s %19s %18s\n", "", "", "hs cold, ns", "hs warm, ns", "Box2D, ns",
              "ratio to Box2D", "wrong verdicts");
  std::printf("%8s %-6s %7s %7s %7s %7s %7s %7s %9s %9s %6s %5s %5s\n", "vertices", "set", "min", "median", "min",
              "median", "min", "median", "cold", "warm", "cold", "warm", "Box2D");
  for (const int vertices : {3, 4, 6, 8}) {
    for (const GapSet& set : gap_sets) run(vertices, set, count, context.get(), random);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const bool quick = has_option(argc, argv, "--quick");
  const int count = quick ? 128 : 4096;
  std::printf("libhalfspace %s, Box2D %d.%d.%d; %d pairs a set, %d passes, core %d\n", hs_version(), b2_version.major,
              b2_version.minor, b2_version.revision, count, passes, pin_to_this_core());
  try {
    run_all(count);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pairs: %s\n", error.what());
    return 1;
  }
}
