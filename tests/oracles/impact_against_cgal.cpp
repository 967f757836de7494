// hs_pair_time_of_impact against exact verdicts, on random motions kind by kind, in the plane and in space.
//
//   impact_against_cgal [motions] [seed]      default 1000 motions of each kind
//
// Each motion is sampled densely up to the time told, more densely where the shapes come nearest, and judged
// by the exact verdict of exact_pair.h and exact_pair_3d.h. Fails when a touch is missed, that is when an
// overlap beyond the rounding of a sampled place comes before the time told, or when the gap at the time told
// is more than was promised.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "oracles/exact_pair.h"
#include "oracles/exact_pair_3d.h"
#include "oracles/random_pairs.h"
#include "oracles/random_polyhedra.h"

namespace halfspace_test {
namespace {

constexpr double pi = 3.14159265358979323846;
using Real = long double;
struct Real3 {
  Real x, y, z;
};

enum class Kind { tumbling, needles, grazing, parallel_faces, far_away, straining, whirling, unequal };
constexpr struct {
  Kind kind;
  const char* name;
} all_kinds[] = {{Kind::tumbling, "tumbling"}, {Kind::needles, "spinning needles"},
                 {Kind::grazing, "grazing"},   {Kind::parallel_faces, "parallel faces"},
                 {Kind::far_away, "1e6 away"}, {Kind::straining, "straining"},
                 {Kind::whirling, "whirling"}, {Kind::unequal, "of unequal size"}};

double length_of(const double v[3]) { return std::hypot(v[0], v[1], v[2]); }

// ---- where a vertex is at a time, by the formula of hs_motion_def ----

Real3 turned(const Real3& v, const double turn[3], Real share) {
  const Real x = turn[0], y = turn[1], z = turn[2], length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) return v;
  const Real angle = share * length, c = std::cos(angle), s = std::sin(angle);
  const Real ux = x / length, uy = y / length, uz = z / length;
  const Real along = (1 - c) * (ux * v.x + uy * v.y + uz * v.z);
  return {c * v.x + s * (uy * v.z - uz * v.y) + along * ux, c * v.y + s * (uz * v.x - ux * v.z) + along * uy,
          c * v.z + s * (ux * v.y - uy * v.x) + along * uz};
}

Real3 turned_by_quaternion(const Real3& v, const double q[4]) {
  const Real x = q[0], y = q[1], z = q[2], w = q[3], scale = 2 / (x * x + y * y + z * z + w * w);
  const Real tx = y * v.z - z * v.y, ty = z * v.x - x * v.z, tz = x * v.y - y * v.x;
  return {v.x + scale * (w * tx + y * tz - z * ty), v.y + scale * (w * ty + z * tx - x * tz),
          v.z + scale * (w * tz + x * ty - y * tx)};
}

/// Of a vertex in the shape's frame, relative to the centroid; in a duration of 1 s, relative to an origin
/// that goes with `other`, so that what both share costs no digits.
Point3 placed(const Point3& vertex, const hs_motion_def& m, const hs_motion_def& other, Real time) {
  const double v[3] = {vertex.x, vertex.y, vertex.z};
  Real strained[3];
  for (int i = 0; i < 3; ++i) {
    strained[i] = 0;
    for (int k = 0; k < 3; ++k)
      strained[i] += (m.gradient[3 * i + k] + time * m.gradient_rate[3 * i + k]) * Real(v[k]);
  }
  const Real3 at_start = turned_by_quaternion({strained[0], strained[1], strained[2]}, m.start.rotation);
  const Real3 now = turned(at_start, m.angular_velocity, time);
  const auto position = [&](int i) {
    return (Real(m.start.position[i]) - other.start.position[i]) +
           time * (Real(m.velocity[i]) - other.velocity[i]);
  };
  return {double(now.x + position(0)), double(now.y + position(1)), double(now.z + position(2))};
}

constexpr hs_pose unmoved = {{0, 0, 0}, {0, 0, 0, 1}};

/// The largest gap and the exact verdict.
struct Verdict {
  bool touches;
  double gap;
};

// ---- what the plane and space have for themselves ----

struct Plane {
  using Body = Points;  // about the centroid

  static Body regular(Random& random) {
    Body points;
    const int n = whole_between(random, 3, 8);
    const double phase = uniform_between(random, 0, 2 * pi);
    for (int i = 0; i < n; ++i) {
      const double angle = phase + 2 * pi * (i + uniform_between(random, -0.3, 0.3)) / n;
      points.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle)});
    }
    return points;
  }
  static Body needle(Random& random) {
    const double half = 0.5 * std::pow(10, uniform_between(random, -6, -1));
    return box(-0.5, -half, 0.5, half);
  }
  static Body brick(Random& random) {
    const double x = uniform_between(random, 0.1, 0.5), y = uniform_between(random, 0.1, 0.5);
    return box(-x, -y, x, y);
  }
  static Body scaled(Body body, double factor) {
    for (Point& p : body) p = {factor * p.x, factor * p.y};
    return body;
  }
  static Shape shape_of(hs_context* context, const Body& body) { return make_shape(context, body); }
  static void centre(Body& body, const double centroid[3]) {
    for (Point& p : body) p = {p.x - centroid[0], p.y - centroid[1]};
  }
  static Point3 direction(Random& random) {
    const double angle = uniform_between(random, 0, 2 * pi);
    return {std::cos(angle), std::sin(angle), 0};
  }
  static Point3 axis(Random&) { return {0, 0, 1}; }
  static void turn_at_random(hs_pose& pose, Random& random) {
    const double angle = uniform_between(random, -pi, pi);
    pose.rotation[2] = std::sin(angle / 2);
    pose.rotation[3] = std::cos(angle / 2);
  }
  template <class Place>
  static Points moved(const Body& body, Place place) {
    Points points;
    for (const Point& p : body) {
      const Point3 at = place(Point3{p.x, p.y, 0});
      points.push_back({at.x, at.y});
    }
    return points;
  }
  static Verdict judge(const Body& a, const Body& b) {
    const ExactVerdict exact = exact_verdict({&a, {0, 0}, unmoved}, {&b, {0, 0}, unmoved});
    return {exact.touches, double(exact.largest_gap)};
  }
  template <class Use>
  static void for_each_vertex(const Body& body, Use use) {
    for (const Point& p : body) use(Point3{p.x, p.y, 0});
  }
};

struct Space {
  using Body = Polyhedron;

  static Body regular(Random& random) { return round_polyhedron(whole_between(random, 4, 12), 0.5, random); }
  static Body needle(Random& random) {
    const double y = 0.5 * std::pow(10, uniform_between(random, -6, -1)),
                 z = y * uniform_between(random, 1, 3);
    return box_3d({-0.5, -y, -z}, {0.5, y, z});
  }
  static Body brick(Random& random) {
    const auto half = [&] { return uniform_between(random, 0.1, 0.5); };
    const Point3 corner{half(), half(), half()};
    return box_3d({-corner.x, -corner.y, -corner.z}, corner);
  }
  static Body scaled(const Body& body, double factor) {
    return moved(body, [&](const Point3& p) { return factor * p; });
  }
  static Shape shape_of(hs_context* context, const Body& body) {
    const Points3& p = body.vertices;
    hs_shape* shape = nullptr;
    require_ok(hs_polyhedron_create_hull(
                   context, {&p[0].x, &p[0].y, &p[0].z, sizeof(Point3), std::int64_t(p.size())}, &shape),
               context);
    return Shape(shape);
  }
  static void centre(Body& body, const double c[3]) {
    for (Point3& p : body.vertices) p = {p.x - c[0], p.y - c[1], p.z - c[2]};
    body.centre = {0, 0, 0};
  }
  static Point3 direction(Random& random) { return random_direction(random); }
  static Point3 axis(Random& random) { return random_direction(random); }
  static void turn_at_random(hs_pose& pose, Random& random) {
    pose = turned_at_random({pose.position[0], pose.position[1], pose.position[2]}, random);
  }
  template <class Place>
  static Body moved(const Body& body, Place place) {
    Body out = body;
    for (Point3& p : out.vertices) p = place(p);
    return out;
  }
  static Verdict judge(const Body& a, const Body& b) {
    const PlacedPolyhedron at_a{&a, unmoved}, at_b{&b, unmoved};
    const ExactVerdict3 exact = exact_verdict(at_a, at_b, MinkowskiFacets(at_a, at_b));
    return {exact.touches, exact.gap};
  }
  template <class Use>
  static void for_each_vertex(const Body& body, Use use) {
    for (const Point3& p : body.vertices) use(p);
  }
};

// ---- random motions ----

template <class Geometry>
struct Scene {
  typename Geometry::Body a, b;
  hs_motion_def of_a, of_b;
};

hs_motion_def at_rest() {
  hs_motion_def motion;
  if (hs_motion_def_init(&motion, sizeof motion) != HS_OK) std::abort();
  return motion;
}

void set(double out[3], const Point3& v) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

template <class Geometry>
double radius_of(const typename Geometry::Body& body) {
  double radius = 0;
  Geometry::for_each_vertex(body, [&](const Point3& p) { radius = std::max(radius, length(p)); });
  return radius;
}

/// The vertex that reaches farthest along a direction, as the body is at the start, about its centroid.
template <class Geometry>
Point3 farthest(const typename Geometry::Body& body, const hs_motion_def& motion, const Point3& direction) {
  hs_motion_def centred = motion;
  set(centred.start.position, {0, 0, 0});
  Point3 vertex;
  double reach = -HUGE_VAL;
  Geometry::for_each_vertex(body, [&](const Point3& p) {
    const Point3 at = placed(p, centred, at_rest(), 0);
    if (dot(at, direction) <= reach) return;
    reach = dot(at, direction);
    vertex = at;
  });
  return vertex;
}

template <class Geometry>
void tumble(Scene<Geometry>& s, double most_turn, Random& random) {
  for (hs_motion_def* motion : {&s.of_a, &s.of_b}) {
    Geometry::turn_at_random(motion->start, random);
    set(motion->angular_velocity, uniform_between(random, -most_turn, most_turn) * Geometry::axis(random));
    set(motion->velocity, uniform_between(random, 0, 1) * Geometry::direction(random));
  }
  const Point3 away = uniform_between(random, 0.5, 2) * Geometry::direction(random);
  set(s.of_b.start.position, away);
  for (int i = 0; i < 3; ++i) s.of_b.velocity[i] -= uniform_between(random, 0, 2) * s.of_b.start.position[i];
}

/// A grain flies at a block up to 1e6 times as large, from a few of its own widths away.
template <class Geometry>
void throw_grain(Scene<Geometry>& s, Random& random) {
  tumble(s, 3, random);
  const Point3 n = Geometry::direction(random), slip = Geometry::direction(random);
  const Point3 minus{-n.x, -n.y, -n.z};
  const double size = radius_of<Geometry>(s.b), away = uniform_between(random, 0, 3) * size;
  set(s.of_b.start.position,
      farthest<Geometry>(s.a, s.of_a, n) - farthest<Geometry>(s.b, s.of_b, minus) + away * n);
  set(s.of_b.velocity,
      uniform_between(random, -6, 1) * size * n + uniform_between(random, 0, 6) * size * slip);
  for (hs_motion_def* motion : {&s.of_a, &s.of_b}) {
    for (double& rate : motion->angular_velocity) rate *= motion == &s.of_a ? size : 1;
  }
  set(s.of_a.velocity, {0, 0, 0});
}

/// A vertex of b passes one of a along a plane that both bodies reach to, but for a gap or overlap of any
/// smallness.
template <class Geometry>
void graze(Scene<Geometry>& s, Random& random) {
  tumble(s, 0, random);
  const Point3 n = Geometry::direction(random), other = Geometry::direction(random);
  const Point3 across = other - dot(other, n) * n;
  const double off = (random() % 2 ? 1 : -1) * std::pow(10, uniform_between(random, -14, -2));
  const double speed = uniform_between(random, 2, 6) / std::max(0.1, length(across));
  const Point3 meeting = farthest<Geometry>(s.a, s.of_a, n) -
                         farthest<Geometry>(s.b, s.of_b, Point3{-n.x, -n.y, -n.z}) + off * n;
  set(s.of_b.start.position, meeting - (0.5 * speed) * across);
  set(s.of_a.velocity, {0, 0, 0});
  set(s.of_b.velocity, speed * across);
  if (random() % 2)
    set(s.of_b.angular_velocity, uniform_between(random, -1e-3, 1e-3) * Geometry::axis(random));
}

/// Bricks with faces that look at each other and turn alike, and go along, apart or together.
template <class Geometry>
void keep_parallel(Scene<Geometry>& s, Random& random) {
  const double gap = std::pow(10, uniform_between(random, -12, 0));
  const double height =
      farthest<Geometry>(s.a, s.of_a, {1, 0, 0}).x - farthest<Geometry>(s.b, s.of_b, {-1, 0, 0}).x + gap;
  const double sideways = uniform_between(random, -0.3, 0.3), closing = uniform_between(random, -2, 2) * gap;
  set(s.of_b.start.position, {height, sideways, 0});
  set(s.of_b.velocity, {-closing, random() % 2 ? uniform_between(random, -1, 1) : 0, 0});
  if (random() % 2) return;
  // The pair turns as a whole, and so that its faces stay parallel each about its own centre.
  const Point3 turn =
      uniform_between(random, -1, 1) * (random() % 2 ? Geometry::axis(random) : Point3{0, 0, 1});
  set(s.of_a.angular_velocity, turn);
  set(s.of_b.angular_velocity, turn);
}

template <class Geometry>
Scene<Geometry> draw(Kind kind, Random& random) {
  Scene<Geometry> s{Geometry::regular(random), Geometry::regular(random), at_rest(), at_rest()};
  switch (kind) {
    case Kind::needles:
      s.a = Geometry::needle(random);
      if (random() % 2) s.b = Geometry::needle(random);
      break;
    case Kind::parallel_faces:
      s.a = Geometry::brick(random);
      s.b = Geometry::brick(random);
      break;
    case Kind::unequal:
      s.b = Geometry::scaled(s.b, std::pow(10, uniform_between(random, -6, 0)));
      break;
    default:
      break;
  }
  return s;
}

template <class Geometry>
void set_in_motion(Scene<Geometry>& s, Kind kind, Random& random) {
  switch (kind) {
    case Kind::tumbling:
    case Kind::straining:
    case Kind::far_away:
      tumble(s, random() % 2 ? 0.5 : 10, random);
      break;
    case Kind::needles:
      tumble(s, 60, random);
      break;
    case Kind::whirling:
      tumble(s, 100, random);
      break;
    case Kind::unequal:
      throw_grain(s, random);
      break;
    case Kind::grazing:
      graze(s, random);
      break;
    case Kind::parallel_faces:
      keep_parallel(s, random);
      break;
  }
  if (kind == Kind::straining) {
    for (hs_motion_def* motion : {&s.of_a, &s.of_b})
      for (double& rate : motion->gradient_rate) rate = uniform_between(random, -0.2, 0.2);
  }
  if (kind == Kind::far_away) {
    const Point3 far = 1e6 * Geometry::direction(random), shared = 1e3 * Geometry::direction(random);
    for (hs_motion_def* motion : {&s.of_a, &s.of_b}) {
      const double place[3] = {far.x, far.y, far.z}, speed[3] = {shared.x, shared.y, shared.z};
      for (int i = 0; i < 3; ++i) {
        motion->start.position[i] += place[i];
        motion->velocity[i] += speed[i];
      }
    }
  }
}

// ---- the judgement ----

struct Tally {
  long motions = 0;
  long states[3] = {};
  long missed = 0;
  long early = 0;
  double worst_gap = 0;  // at the time told, in what was promised
  long looks = 0;
};

/// Lengths that rounding goes with: both radii times 1 and the angle, the distance and the way.
template <class Geometry>
double extent_of(const Scene<Geometry>& s) {
  double extent = 0;
  for (int i = 0; i < 3; ++i) {
    extent += std::abs(s.of_b.start.position[i] - s.of_a.start.position[i]) +
              std::abs(s.of_b.velocity[i] - s.of_a.velocity[i]);
  }
  return extent + 2 * radius_of<Geometry>(s.a) * (1 + length_of(s.of_a.angular_velocity)) +
         2 * radius_of<Geometry>(s.b) * (1 + length_of(s.of_b.angular_velocity));
}

template <class Geometry>
void judge(const Scene<Geometry>& s, const hs_impact& impact, Tally& tally) {
  ++tally.motions;
  ++tally.states[impact.state];
  const double extent = extent_of(s);
  const double rounding = 16 * 0x1p-53 * extent;  // of the places that are judged
  const auto verdict_at = [&](double time) {
    ++tally.looks;
    const auto a = Geometry::moved(s.a, [&](const Point3& p) { return placed(p, s.of_a, s.of_a, time); });
    const auto b = Geometry::moved(s.b, [&](const Point3& p) { return placed(p, s.of_b, s.of_a, time); });
    return Geometry::judge(a, b);
  };
  const auto is_missed = [&](const Verdict& v) { return v.touches && v.gap < -rounding; };
  if (impact.state == HS_IMPACT_AT_START) {
    tally.early += verdict_at(0).gap > rounding;
    return;
  }
  const Verdict then = verdict_at(impact.time);
  bool missed = is_missed(then);
  if (impact.state == HS_IMPACT_TOUCH) {
    const double promised = 1e-12 * extent;
    tally.worst_gap = std::max(tally.worst_gap, then.gap / promised);
    tally.early += then.gap > promised;
  }
  // Some ten in each radian that they turn by.
  const int samples =
      64 + int(10 * std::max(length_of(s.of_a.angular_velocity), length_of(s.of_b.angular_velocity)));
  std::vector<double> gaps(std::size_t(samples) + 1);
  for (int i = 0; i <= samples; ++i) {
    const Verdict v = i < samples ? verdict_at(impact.time * i / samples) : then;
    gaps[std::size_t(i)] = v.gap;
    missed |= is_missed(v);
  }
  // Between samples, about the least gap that is not the last, by golden section.
  const int least = int(std::min_element(gaps.begin() + 1, gaps.end() - 1) - gaps.begin());
  double from = impact.time * (least - 1) / samples, to = impact.time * (least + 1) / samples;
  for (int i = 0; i < 40 && !missed; ++i) {
    const double step = 0.3819660112501051 * (to - from), one = from + step, other = to - step;
    const Verdict at_one = verdict_at(one), at_other = verdict_at(other);
    missed = is_missed(at_one) || is_missed(at_other);
    (at_one.gap < at_other.gap ? to : from) = at_one.gap < at_other.gap ? other : one;
  }
  if (missed && ++tally.missed <= 3) {
    std::printf("MISSED: told %d at %.17g\n", impact.state, impact.time);
  }
}

template <class Geometry>
Tally run(Kind kind, long motions, std::uint64_t seed) {
  const Context context = make_context();
  Random random(seed + 17 * std::uint64_t(kind));
  Tally tally;
  while (tally.motions < motions) {
    Scene<Geometry> s = draw<Geometry>(kind, random);
    const Shape a = Geometry::shape_of(context.get(), s.a), b = Geometry::shape_of(context.get(), s.b);
    Geometry::centre(s.a, properties_of(a.get()).centroid);
    Geometry::centre(s.b, properties_of(b.get()).centroid);
    set_in_motion(s, kind, random);
    hs_impact impact;
    require_ok(hs_pair_time_of_impact(a.get(), &s.of_a, b.get(), &s.of_b, 1, &impact), context.get());
    judge(s, impact, tally);
  }
  return tally;
}

template <class Geometry>
bool run_all(const char* dimension, long motions, std::uint64_t seed) {
  bool clean = true;
  for (const auto& [kind, name] : all_kinds) {
    const Tally t = run<Geometry>(kind, motions, seed);
    std::printf("%s %-16s %8ld %8ld %8ld %8ld %8ld %8ld %8.2f %10ld\n", dimension, name, t.motions,
                t.states[HS_IMPACT_NEVER], t.states[HS_IMPACT_AT_START], t.states[HS_IMPACT_TOUCH], t.missed,
                t.early, t.worst_gap, t.looks);
    clean &= t.missed == 0 && t.early == 0;
  }
  return clean;
}

}  // namespace
}  // namespace halfspace_test

int main(int argc, char** argv) {
  using namespace halfspace_test;
  const long motions = argc > 1 ? std::atol(argv[1]) : 1000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::printf("gap: the largest at a time told, in 1e-12 of radii (1 + angle), distance and way\n");
  std::printf("%19s %8s %8s %8s %8s %8s %8s %8s %10s\n", "kind", "motions", "never", "at start", "touch",
              "missed", "early", "gap", "looks");
  const bool in_plane = run_all<Plane>("2D", motions, seed), in_space = run_all<Space>("3D", motions, seed);
  return in_plane && in_space ? 0 : 1;
}
