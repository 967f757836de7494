#pragma once

// Affine blocks, for tests that strain them and look at what comes of it.

#include <Eigen/Dense>

#include "validation/solid_scene.h"

namespace halfspace_test {

/// As hs_deformation holds them; in 2D the upper left part counts.
using Tensor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline Tensor tensor(const double values[9]) { return Eigen::Map<const Tensor>(values); }

/// An isotropic material, with the constants that theory writes its formulas in.
struct Elastic {
  double young = 1e9;
  double poisson = 0.25;
  int32_t plane = HS_PLANE_STRAIN;
  double damping_time = 0;

  double shear() const { return young / (2 * (1 + poisson)); }
  /// Lame's first constant, in plane stress that of the plane.
  double lame() const {
    return plane == HS_PLANE_STRESS ? young * poisson / (1 - poisson * poisson)
                                    : young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  }
};

inline void set_elastic(const Scene& scene, const Elastic& elastic, int32_t material = 0) {
  hs_elasticity_def def;
  scene.check(hs_elasticity_def_init(&def, sizeof def));
  def.young_modulus = elastic.young;
  def.poisson_ratio = elastic.poisson;
  def.plane = elastic.plane;
  def.damping_time = elastic.damping_time;
  scene.check(hs_world_set_elasticity(scene.world(), material, &def));
}

inline hs_deformation deformation_of(const Scene& scene, hs_block block) {
  hs_deformation deformation;
  scene.check(hs_world_get_deformation(scene.world(), block, &deformation));
  return deformation;
}
inline Tensor gradient_of(const Scene& scene, hs_block block) {
  return tensor(deformation_of(scene, block).gradient);
}
inline Tensor stress_of(const Scene& scene, hs_block block) {
  return tensor(deformation_of(scene, block).stress);
}

inline void deform(const Scene& scene, hs_block block, const Tensor& gradient, const Tensor& rate) {
  scene.check(hs_world_set_deformation(scene.world(), block, gradient.data(), rate.data()));
}

/// Loads all edges of a polygon so that its stress is in equilibrium.
inline void load_edges(const Scene& scene, hs_block block, const Points& vertices, const Tensor& stress) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point from = vertices[i], to = vertices[(i + 1) % vertices.size()];
    const Eigen::Vector3d normal = Eigen::Vector3d(to.y - from.y, from.x - to.x, 0).normalized();
    const Eigen::Vector3d traction = stress * normal;
    scene.check(hs_world_add_surface_load(scene.world(), block, int32_t(i), traction.data()));
  }
}

/// Of a box of these sides: density times the integral of X X^T, which is diagonal.
inline Eigen::Vector3d mass_matrix_of_box(double density, const Triple& sides) {
  const double mass = density * sides[0] * sides[1] * sides[2];
  return mass / 12 * Eigen::Vector3d(sides[0] * sides[0], sides[1] * sides[1], sides[2] * sides[2]);
}

}  // namespace halfspace_test
