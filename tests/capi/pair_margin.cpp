// halfspace/pair.h: detection for hosts whose blocks wear a skin (margin) and that make their own contact
// points (without_region).

#include <algorithm>
#include <cmath>
#include <random>

#include "benchmarks/random_polygon.h"
#include "capi/pair_calls.h"
#include "catch.h"

namespace halfspace_test {
namespace {

using halfspace_benchmark::Random;
using halfspace_benchmark::random_polygon;
using halfspace_benchmark::uniform;

hs_pair_options options_of(double margin, bool without_region) {
  hs_pair_options options;
  require_ok(hs_pair_options_init(&options, sizeof options), nullptr);
  options.margin = margin;
  options.without_region = without_region;
  return options;
}

struct Pair {
  Shape a, b;
  hs_pose at_a = pose_at(0, 0), at_b = pose_at(0, 0);

  hs_contact detect(const hs_pair_options& options, hs_pair_cache* cache = nullptr) const {
    hs_contact contact{};
    require_ok(hs_pair_detect(a.get(), &at_a, b.get(), &at_b, &options, cache, &contact), nullptr);
    return contact;
  }
};

Points laid(const hs_shape* shape, const hs_pose& pose) {
  const hs_shape_properties properties = properties_of(shape);
  const double z = pose.rotation[2], w = pose.rotation[3], c = w * w - z * z, s = 2 * z * w;
  Points points = vertices_of(shape);
  for (Point& p : points) {
    const double x = p.x - properties.centroid[0], y = p.y - properties.centroid[1];
    p = {pose.position[0] + (c * x - s * y), pose.position[1] + (s * x + c * y)};
  }
  return points;
}

/// Largest over all edges of both of the least height of the other's vertices: all against all.
double largest_gap(const Pair& pair) {
  const Points a = laid(pair.a.get(), pair.at_a), b = laid(pair.b.get(), pair.at_b);
  double largest = -INFINITY;
  const auto over_edges_of = [&](const Points& owner, const Points& other) {
    for (std::size_t i = 0; i < owner.size(); ++i) {
      const Point from = owner[i], to = owner[(i + 1) % owner.size()];
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      double least = INFINITY;
      for (const Point& p : other)
        least =
            std::min(least, ((p.x - from.x) * (to.y - from.y) - (p.y - from.y) * (to.x - from.x)) / length);
      largest = std::max(largest, least);
    }
  };
  over_edges_of(a, b);
  over_edges_of(b, a);
  return largest;
}

Pair draw_pair(hs_context* context, int vertices_of_a, int vertices_of_b, Random& random) {
  Pair pair;
  pair.a = make_shape(context, random_polygon(vertices_of_a, 1, random));
  pair.b = make_shape(context, random_polygon(vertices_of_b, 1, random));
  const double half = uniform(random, -3.2, 3.2), direction = uniform(random, -3.2, 3.2);
  const double distance = uniform(random, 1.2, 2.2);
  pair.at_b = pose_at(distance * std::cos(direction), distance * std::sin(direction), std::sin(half / 2),
                      std::cos(half / 2));
  return pair;
}

}  // namespace

TEST_CASE("margin: separated only when a gap exceeds it, in every way of searching") {
  const Context context = make_context();
  Random random(1);
  const double margin = 0.1;
  int apart = 0, together = 0, overlapping = 0;
  // Triangles, all combinations, and the merge of many vertices.
  for (const auto& [m, n] : {std::pair(3, 3), {3, 4}, {8, 5}, {60, 50}}) {
    for (int i = 0; i < 500; ++i) {
      const Pair pair = draw_pair(context.get(), m, n, random);
      const double gap = largest_gap(pair);
      for (const bool without_region : {false, true}) {
        const hs_contact contact = pair.detect(options_of(margin, without_region));
        if (gap > margin) {
          CHECK(contact.type == HS_CONTACT_NONE);
          CHECK(contact.gap > margin);
          ++apart;
          continue;
        }
        CHECK(contact.type != HS_CONTACT_NONE);
        (gap > 0 ? together : overlapping) += 1;
        CHECK(contact.point_count == (without_region ? 0 : std::clamp(contact.point_count, 1, 2)));
        if (without_region) {
          CHECK(contact.type == HS_CONTACT_VERTEX_EDGE);
          CHECK(contact.gap == Approx(gap).margin(1e-14));
        }
      }
    }
  }
  CHECK(std::min({apart, together, overlapping}) > 100);
}

TEST_CASE("margin: the pair of largest gap is its edge, its vertex, and its normal from a to b") {
  const Context context = make_context();
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Pair pair = draw_pair(context.get(), 5, 6, random);
    const hs_contact contact = pair.detect(options_of(0.2, true));
    if (contact.type == HS_CONTACT_NONE) continue;
    const EdgeAndVertex named = edge_and_vertex(contact);
    const Points a = laid(pair.a.get(), pair.at_a), b = laid(pair.b.get(), pair.at_b);
    const Points &owner = named.owner == 0 ? a : b, &other = named.owner == 0 ? b : a;
    const Point from = owner[std::size_t(named.edge)];
    const Point vertex = other[std::size_t(named.vertex)];
    const double sign = named.owner == 0 ? 1 : -1;
    CHECK(sign * (contact.normal[0] * (vertex.x - from.x) + contact.normal[1] * (vertex.y - from.y)) ==
          Approx(largest_gap(pair)).margin(1e-14));
  }
}

TEST_CASE("margin: a proof of separation holds while more than the margin is left") {
  const Context context = make_context();
  Random random(3);
  hs_pair_cache cache{};
  int by_proof = 0;
  for (int i = 0; i < 200; ++i) {
    Pair pair = draw_pair(context.get(), 4, 4, random);
    for (int step = 0; step < 50; ++step) {
      pair.at_b.position[0] *= 0.999;
      pair.at_b.position[1] *= 0.999;
      const bool had_proof = cache.shapes != 0;
      const hs_contact contact = pair.detect(options_of(0.05, true), &cache);
      const double gap = largest_gap(pair);
      CHECK((contact.type == HS_CONTACT_NONE) == (gap > 0.05));
      by_proof += had_proof && contact.type == HS_CONTACT_NONE;
      // Of a contact nothing is remembered.
      if (contact.type != HS_CONTACT_NONE) CHECK(cache.state == 0);
    }
  }
  CHECK(by_proof > 100);
}

TEST_CASE("margin: a proof found without one does not answer for it") {
  PairCall call(&PairCall::square);
  call.poses[1] = pose_at(2.01, 0);  // a gap of 0.01
  REQUIRE(call.single() == HS_OK);
  REQUIRE(call.contacts[0].type == HS_CONTACT_NONE);
  call.options.margin = 0.02;
  REQUIRE(call.single() == HS_OK);
  CHECK(call.contacts[0].type != HS_CONTACT_NONE);
  CHECK(call.contacts[0].gap == Approx(0.01));
  call.options.margin = 0.005;
  REQUIRE(call.batch() == HS_OK);
  CHECK(call.touching == 0);
}

TEST_CASE("margin: scaling by a power of two scales the answer, bit by bit") {
  const Context context = make_context();
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Points a = random_polygon(5, 1, random), b = random_polygon(4, 1, random);
    const double distance = uniform(random, 1.4, 2);
    const auto scaled = [&](double factor) {
      const auto times = [&](Points points) {
        for (Point& p : points) p = {factor * p.x, factor * p.y};
        return points;
      };
      Pair pair;
      pair.a = make_shape(context.get(), times(a));
      pair.b = make_shape(context.get(), times(b));
      pair.at_b = pose_at(factor * distance, 0, 0.6, 0.8);
      return pair.detect(options_of(factor * 0.1, true));
    };
    const hs_contact one = scaled(1), large = scaled(1024);
    CHECK(large.type == one.type);
    CHECK(large.feature_a == one.feature_a);
    CHECK(large.feature_b == one.feature_b);
    CHECK(large.gap == 1024 * one.gap);
  }
}

TEST_CASE("margin and without_region are for polygons") {
  for (const bool far_apart : {false, true}) {
    PairCall call(&PairCall::solid);
    if (far_apart) call.poses[1] = pose_at(9, 0);
    REQUIRE(call.single() == HS_OK);  // leaves a proof when they are apart
    call.options.margin = 0.5;
    check_refusals(call.context.get(), "hs_pair_detect", {{"margin", "0.5", [&] { return call.single(); }}});
    check_refusals(call.context.get(), "hs_pairs_detect", {{"margin", "0.5", [&] { return call.batch(); }}});
    call.options.margin = 0;
    call.options.without_region = 1;
    check_refusals(call.context.get(), "hs_pair_detect",
                   {{"without_region", "1", [&] { return call.single(); }}});
  }
}

}  // namespace halfspace_test
