// The normal forces of a contact press: their resultant acts within the region where the blocks touch. A
// block whose centroid is beyond its base therefore falls, however deep its springs let it sink.

#include <Eigen/Dense>

#include "catch.h"
#include "validation/random_bodies.h"

namespace {

using namespace halfspace_test;

using Place = Eigen::Vector3d;
using Places = std::vector<Place>;

Place place_of(const double v[3]) { return {v[0], v[1], v[2]}; }

struct HalfSpace {
  Place normal;  // outward
  double offset;
};

/// A prism over a polygon in x and its last axis, as deep as it is told across; in the plane, the polygon.
struct Prism {
  int dimension;
  Corners corners;

  static Prism random(Random& random, int dimension) {
    const int sides = 3 + int(random.uniform(0, 4.999));
    std::vector<double> angles;
    // One corner in each part of the turn, so that none has too sharp an edge.
    for (int i = 0; i < sides; ++i) angles.push_back(2 * pi * (i + random.uniform(0.15, 0.85)) / sides);
    Prism prism{dimension, {}};
    for (const double y : {-0.4, 0.5}) {
      for (const double angle : angles) {
        if (dimension == 3)
          prism.corners.push_back({0.5 * std::cos(angle), 0.6 * std::sin(angle), y});
        else if (y > 0)
          prism.corners.push_back({0.5 * std::cos(angle), 0.6 * std::sin(angle), 0});
      }
    }
    return prism;
  }
};

/// All faces of the hull of points: the planes, or lines, through points that have all others behind them.
std::vector<HalfSpace> faces_of(const Places& points, int dimension) {
  std::vector<HalfSpace> faces;
  const auto add = [&](Place normal, const Place& through) {
    const double length = normal.norm();
    if (length < 1e-12) return;
    normal /= length;
    for (const double sign : {1.0, -1.0}) {
      const HalfSpace face{sign * normal, sign * normal.dot(through)};
      const auto is_this = [&](const HalfSpace& f) { return f.normal.dot(face.normal) > 1 - 1e-9; };
      if (std::any_of(faces.begin(), faces.end(), is_this)) continue;
      if (std::all_of(points.begin(), points.end(),
                      [&](const Place& p) { return face.normal.dot(p) <= face.offset + 1e-10; }))
        faces.push_back(face);
    }
  };
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Place side = points[j] - points[i];
      if (dimension == 2) add({side.y(), -side.x(), 0}, points[i]);
      for (std::size_t k = j + 1; dimension == 3 && k < n; ++k)
        add(side.cross(points[k] - points[i]), points[i]);
    }
  }
  return faces;
}

/// The corners of what lies behind all faces.
Places corners_of(const std::vector<HalfSpace>& faces, int dimension) {
  Places corners;
  const std::size_t n = faces.size();
  const auto add = [&](const HalfSpace& f, const HalfSpace& g, const HalfSpace& h) {
    Eigen::Matrix3d normals;
    normals << f.normal.transpose(), g.normal.transpose(), h.normal.transpose();
    if (std::abs(normals.determinant()) < 1e-9) return;
    const Place p = normals.inverse() * Place(f.offset, g.offset, h.offset);
    if (std::all_of(faces.begin(), faces.end(),
                    [&](const HalfSpace& face) { return face.normal.dot(p) <= face.offset + 1e-10; }))
      corners.push_back(p);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (dimension == 2) add(faces[i], faces[j], {{0, 0, 1}, 0});
      for (std::size_t k = j + 1; dimension == 3 && k < n; ++k) add(faces[i], faces[j], faces[k]);
    }
  }
  return corners;
}

/// How far a line along a direction passes outside the hull of points.
double miss(const Places& points, const Place& on_line, const Place& direction, int dimension) {
  const Place first = dimension == 2
                          ? Place(-direction.y(), direction.x(), 0)
                          : direction.cross(Place::Unit(std::abs(direction.x()) < 0.5 ? 0 : 1)).normalized();
  const Place second = dimension == 2 ? Place(0, 0, 1) : Place(direction.cross(first));
  // The hull seen along the line has it inside unless some direction has all points on one side. Only those
  // square to a side of the hull matter, but for a hull that is a point or a segment: many directions do,
  // too.
  double most = 0;
  const auto look = [&](const Place& outward) {
    double support = -HUGE_VAL;
    for (const Place& p : points) support = std::max(support, outward.dot(p - on_line));
    most = std::max(most, -support);
  };
  constexpr int directions = 64;
  for (int i = 0; i < directions; ++i)
    look(std::cos(2 * pi * i / directions) * first + std::sin(2 * pi * i / directions) * second);
  for (const Place& p : points) {
    for (const Place& q : points) {
      const Place side = q - p;
      const Place outward = side.dot(second) * first - side.dot(first) * second;
      if (outward.norm() > 1e-12) look(outward.normalized());
    }
  }
  return most;
}

struct Pressure {
  bool is_pressed;
  double miss;  // of the region
};

/// One random pair, as it lies and moves.
Pressure press(Random& random, int dimension, int32_t kind, bool is_damped) {
  hs_law_def law = spring_law(1e8);
  law.stiffness_kind = kind;
  if (is_damped) law.normal_damping = random.uniform(0, 1);
  hs_world_def def = solid_world_def(0, {0, 0, 0});
  def.dimension = dimension;
  def.potential_length = 1;
  const Prism below = Prism::random(random, dimension), above = Prism::random(random, dimension);
  const double depth = std::pow(10, random.uniform(-7, -1.5)), tilt = std::pow(10, random.uniform(-7, 0));
  const double aside = random.uniform(-0.6, 0.6);

  // A side of the lower one is turned up, and one of the upper one down to it, but for the tilt.
  const int up = dimension - 1;
  const auto turned_to = [&](const Prism& prism, double to, double by) {
    // From corner 0 to corner 1 of the polygon leads its first side.
    const Triple side = prism.corners[1] - prism.corners[0];
    const double angle = to - std::atan2(side[1], side[0]) + by;
    Corners turned;
    for (const Triple& c : prism.corners) {
      const double x = std::cos(angle) * c[0] - std::sin(angle) * c[1];
      const double y = std::sin(angle) * c[0] + std::cos(angle) * c[1];
      if (dimension == 2) {
        turned.push_back({x, y, 0});
      } else {
        // The polygon stands upright, and the tilt is about both axes.
        const double sine = std::sin(0.37 * by), cosine = std::cos(0.37 * by);
        turned.push_back({x, cosine * c[2] - sine * y, sine * c[2] + cosine * y});
      }
    }
    return turned;
  };
  Corners lower = turned_to(below, pi, 0), upper = turned_to(above, 0, tilt);
  double top = -HUGE_VAL, bottom = HUGE_VAL;
  for (const Triple& c : lower) top = std::max(top, c[std::size_t(up)]);
  for (const Triple& c : upper) bottom = std::min(bottom, c[std::size_t(up)]);
  for (Triple& c : upper) {
    c[0] += aside;
    if (dimension == 3) c[1] += 0.5 * aside;
    c[std::size_t(up)] += top - depth - bottom;
  }
  SolidScene scene(def, law);
  const auto add = [&](const Corners& corners, int32_t block_kind) {
    if (dimension == 3) return scene.add_hull_in_place(corners, block_kind);
    Points points;
    for (const Triple& c : corners) points.push_back({c[0], c[1]});
    return scene.add(points, {block_kind, {}, 0});
  };
  add(lower, HS_BLOCK_FIXED);
  const hs_block block = add(upper, HS_BLOCK_RIGID);
  const double speed = is_damped ? std::pow(10, random.uniform(-3, 1)) : 0;
  const auto any = [&] { return speed * random.uniform(-1, 1); };
  const double velocity[3] = {any(), any(), dimension == 3 ? any() : 0};
  const double spin[3] = {dimension == 3 ? any() : 0, dimension == 3 ? any() : 0, any()};
  scene.check(hs_world_set_velocity(scene.world(), block, velocity, spin));

  Triple force[2], torque[2];
  const auto view = [](Triple* v) {
    return hs_mutable_view{&v[0][0], &v[0][1], &v[0][2], sizeof(Triple), 2};
  };
  scene.check(hs_world_detect(scene.world(), nullptr));
  scene.check(hs_world_forces(scene.world(), 0, view(force), view(torque)));
  const std::vector<hs_contact> contacts = scene.contacts();
  const Place f = place_of(force[1].data()), moment = place_of(torque[1].data());
  if (contacts.empty() || f.norm() == 0) return {false, 0};
  const hs_contact& contact = contacts[0];
  const Place centroid = place_of(scene.state(block).pose.position);
  const Place on_line = centroid + f.cross(moment) / f.squaredNorm();
  Places region;
  if (kind == HS_STIFFNESS_PER_CONTACT) {
    for (int i = 0; i < contact.point_count; ++i) region.push_back(place_of(contact.points[i]));
  } else {
    const auto places = [](const Corners& corners) {
      Places all;
      for (const Triple& c : corners) all.push_back(place_of(c.data()));
      return all;
    };
    std::vector<HalfSpace> faces = faces_of(places(lower), dimension);
    const std::vector<HalfSpace> more = faces_of(places(upper), dimension);
    faces.insert(faces.end(), more.begin(), more.end());
    region = corners_of(faces, dimension);
  }
  if (region.empty()) return {false, 0};
  return {true, miss(region, on_line, f.normalized(), dimension)};
}

/// A block that leans over: its centroid beyond the edge of its base, 1 m wide, by so much.
struct Leaning {
  SolidScene scene;
  hs_block block;

  static constexpr double height = 2;

  static hs_world_def def(int dimension) {
    hs_world_def def = solid_world_def(0);
    if (dimension == 2) def = world_def(0);
    def.potential_length = 1;
    return def;
  }

  static hs_law_def law(int32_t kind, double penetration) {
    hs_law_def law = spring_law(2000 * height * 9.81 / penetration, 0.6);
    law.stiffness_kind = kind;
    if (kind == HS_STIFFNESS_POTENTIAL) law.normal_stiffness /= 2;
    law.shear_stiffness = law.normal_stiffness;
    law.normal_damping = law.shear_damping = 0.1;
    return law;
  }

  Leaning(int dimension, int32_t kind, double penetration, double beyond)
      : scene(def(dimension), law(kind, penetration)) {
    const double shift = 1 + 2 * beyond;  // of the upper side: the centroid goes half as far
    if (dimension == 2) {
      scene.add(box(-9, -1, 9, 0), {HS_BLOCK_FIXED, {}, 0});
      block = scene.add({{0, -penetration},
                         {1, -penetration},
                         {1 + shift, height - penetration},
                         {shift, height - penetration}});
    } else {
      scene.add_hull(cuboid({18, 18, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
      Corners corners;
      for (const double y : {0.0, 1.0}) {
        for (const double x : {0.0, 1.0}) {
          corners.push_back({x, y, -penetration});
          corners.push_back({x + shift, y, height - penetration});
        }
      }
      block = scene.add_hull_in_place(corners, HS_BLOCK_RIGID);
    }
  }

  /// Brought to rest without a swing.
  bool stands() {
    const Triple start = scene.place_of(block);
    hs_relaxation_def relaxation;
    hs_relaxation_def_init(&relaxation, sizeof relaxation);
    scene.check(hs_world_relax(scene.world(), &relaxation, nullptr, 0));
    return length(scene.place_of(block) - start) <= 0.2;
  }

  bool falls(double duration) {
    const Triple start = scene.place_of(block);
    while (scene.report().time < duration) {
      scene.step(200);
      if (length(scene.place_of(block) - start) > 0.2) return true;
    }
    return false;
  }
};

}  // namespace

TEST_CASE("a block that leans beyond its base falls, however deep its springs let it sink") {
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      for (const double penetration : {1e-4, 1e-3, 1e-2}) {
        INFO(dimension << "D, " << name_of_stiffness(kind) << ", penetration " << penetration);
        // A metre long pendulum upside down grows by e in half a second: 1 mm has become 0.2 m in 4 s.
        CHECK(Leaning(dimension, kind, penetration, 1e-3).falls(5));
        CHECK(Leaning(dimension, kind, penetration, 0.1).falls(5));
      }
    }
  }
}

TEST_CASE("by springs at its corners a block leans as far as its springs' own yielding leaves it") {
  for (const int dimension : {2, 3}) {
    for (const double penetration : {1e-4, 1e-3, 1e-2}) {
      // Two springs of K/2 a base b apart give way by 4 d e / b^2 under a weight that sinks by d and is off
      // the middle by e, which moves the centroid, h above, by h times that: the base's half is reached from
      // b/2 (1 - 4 d h / b^2).
      const double limit = 0.5 * (1 - 4 * penetration * (Leaning::height / 2));
      INFO(dimension << "D, penetration " << penetration << ", limit " << limit);
      const double margin = 0.002 + 2 * penetration * penetration;
      CHECK(Leaning(dimension, HS_STIFFNESS_PER_CONTACT, penetration, limit + margin - 0.5).falls(6));
      CHECK(Leaning(dimension, HS_STIFFNESS_PER_CONTACT, penetration, limit - margin - 0.5).stands());
      CHECK_FALSE(Leaning(dimension, HS_STIFFNESS_PER_CONTACT, penetration, limit + margin - 0.5).stands());
    }
  }
}

TEST_CASE("the resultant of a contact's normal forces acts within its region, whatever the tilt and motion") {
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      for (const bool is_damped : {false, true}) {
        Random random(11);
        int pressed = 0;
        double most = 0;
        const int rounds = dimension == 2 ? 4000 : 1500;
        for (int round = 0; round < rounds; ++round) {
          const Pressure pressure = press(random, dimension, kind, is_damped);
          pressed += pressure.is_pressed;
          most = std::max(most, pressure.miss);
        }
        std::printf("centre of pressure in %dD, %s, %s: of %d contacts outside the region by %.1e at most\n",
                    dimension, name_of_stiffness(kind), is_damped ? "moving" : "at rest", pressed, most);
        CHECK(pressed > rounds / 2);
        CHECK(most < 1e-9);
      }
    }
  }
}
