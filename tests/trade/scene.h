#pragma once

#include <array>
#include <vector>

namespace halfspace_trade {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // x y z w

constexpr double density = 1000;  // kg/m^3, of bodies that name no other
constexpr double gravity = 9.81;  // m/s^2

/// A box, or another convex body: in the plane a polygon of at most 8 corners, as many as Box2D takes.
struct Body {
  Vector size{1, 1, 1};           // m
  std::vector<Vector> corners{};  // about the centroid, in the plane counter-clockwise; empty for a box
  Vector position{};              // m, of the centroid
  Quaternion rotation{0, 0, 0, 1};
  Vector velocity{};  // m/s
  Vector spin{};      // rad/s
  double density = halfspace_trade::density;
  bool is_fixed = false;
};

/// Every engine is given this. Up is y in the plane and z in space.
struct Scene {
  int dimension = 2;
  std::vector<Body> bodies{};
  Vector gravity{};        // m/s^2
  double friction = 0;     // coefficient
  double restitution = 0;  // 0 or 1
  double duration = 1;     // s
  double load = 0;         // N on the face that bears most: with an indentation it gives a spring's stiffness
  double impact_speed = 0;  // m/s of the fastest impact: likewise
  double damping = 0.1;     // of springs, as a share of the critical one
  bool seeks_rest = false;  // whether it stands is asked: engines that have damping for that may use it
  bool is_settled = false;  // springs bear the load from the start; bodies after the first lie on each other
};

struct State {
  Vector position{};
  Quaternion rotation{0, 0, 0, 1};
  Vector velocity{};
  Vector spin{};
};

/// The corners about the centroid.
std::vector<Vector> corners_of(const Body& body, int dimension);

struct Mass {
  double mass = 0;  // kg; in the plane of a thickness of 1 m
  Vector inertia{};
};
/// Not of hulls in space: the engines that know them find it themselves.
Mass mass_of(const Body& body, int dimension);

/// The first body that moves.
const Body& typical_body(const Scene& scene);

/// The stiffness of a face, N/m, that the scene's load, or its impact, presses in by the indentation.
double face_stiffness(const Scene& scene, double indentation);

}  // namespace halfspace_trade
