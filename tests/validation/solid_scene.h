#pragma once

// A world in space, for tests that say what stands where and look at what comes of it.

#include <array>

#include "validation/scene.h"

namespace halfspace_test {

using Triple = std::array<double, 3>;

inline double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Triple& a) { return std::sqrt(dot(a, a)); }
inline Triple operator-(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Triple operator*(double s, const Triple& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Triple triple(const double v[3]) { return {v[0], v[1], v[2]}; }

/// Unit quaternion x, y, z, w.
using Quaternion = std::array<double, 4>;

inline Quaternion turn_about(const Triple& axis, double angle) {
  const double s = std::sin(angle / 2) / length(axis);
  return {s * axis[0], s * axis[1], s * axis[2], std::cos(angle / 2)};
}

/// First q, then p.
inline Quaternion after(const Quaternion& p, const Quaternion& q) {
  return {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
          p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
          p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
          p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
}

inline const char* name_of_type(std::int32_t type) {
  static const char* const names[] = {"none",      "vertex-vertex", "vertex-edge", "edge-edge",
                                      "edge-face", "face-face",     "vertex-face"};
  return names[type];
}

inline hs_world_def solid_world_def(double time_step, const Triple& gravity = {0, 0, -9.81}) {
  hs_world_def def;
  hs_world_def_init(&def, sizeof def, 3);
  def.time_step = time_step;
  for (std::size_t k = 0; k < 3; ++k) def.gravity[k] = gravity[k];
  return def;
}

using Corners = std::vector<Triple>;

inline Corners cuboid(const Triple& size) {
  Corners corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        {(k & 1 ? 0.5 : -0.5) * size[0], (k & 2 ? 0.5 : -0.5) * size[1], (k & 4 ? 0.5 : -0.5) * size[2]});
  return corners;
}

/// Where a solid starts, and how it moves.
struct SolidStart {
  Triple position{};
  Quaternion rotation{0, 0, 0, 1};
  int32_t kind = HS_BLOCK_RIGID;
  Triple velocity{};
  Triple spin{};
  int32_t material = 0;
};

class SolidScene : public Scene {
 public:
  using Scene::Scene;

  /// The hull of points, its centroid placed.
  hs_block add_hull(const Corners& points, const SolidStart& start) {
    const Shape shape = hull_of(points);
    hs_block_def def;
    check(hs_block_def_init(&def, sizeof def, shape.get()));
    def.kind = start.kind;
    def.material = start.material;
    for (std::size_t k = 0; k < 3; ++k) {
      def.pose.position[k] = start.position[k];
      def.velocity[k] = start.velocity[k];
      def.angular_velocity[k] = start.spin[k];
    }
    for (std::size_t k = 0; k < 4; ++k) def.pose.rotation[k] = start.rotation[k];
    hs_block block = 0;
    check(hs_world_add_block(world(), shape.get(), &def, &block));
    return block;
  }

  /// The hull of points where they are.
  hs_block add_hull_in_place(const Corners& points, int32_t kind) {
    return place(hull_of(points).get(), nullptr, {kind, {}, 0}, 0);
  }

  Triple place_of(hs_block block) const { return triple(state(block).pose.position); }

  /// Of the linear and the angular motion together, the latter at the end of an arm.
  double speed_of(hs_block block, double arm) const {
    const hs_block_state s = state(block);
    return length(triple(s.velocity)) + arm * length(triple(s.angular_velocity));
  }

  /// Type of the only contact, or none.
  std::int32_t contact_type() const {
    const std::vector<hs_contact> all = contacts();
    return all.empty() ? HS_CONTACT_NONE : all[0].type;
  }

 private:
  Shape hull_of(const Corners& points) const {
    hs_shape* made = nullptr;
    const hs_view view{&points[0][0], &points[0][1], &points[0][2], sizeof(Triple),
                       std::int64_t(points.size())};
    check(hs_polyhedron_create_hull(context(), view, &made));
    return Shape(made);
  }
};

}  // namespace halfspace_test
