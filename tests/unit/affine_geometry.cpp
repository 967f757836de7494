#include <Eigen/SVD>

#include "block/blocks.h"
#include "catch.h"
#include "contacts_3d.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

template <int D>
Shape<D> random_shape(Random& random) {
  if constexpr (D == 2) {
    return shape_of(random_polygon(random, 10, 1));
  } else {
    return random_block(random, 12);
  }
}

/// Turned at random, with stretches from `least` to 1 / `least`.
template <int D>
Tensor<D> random_gradient(Random& random, double least) {
  Tensor<D> any;
  for (int k = 0; k < D * D; ++k) any(k) = random.uniform(-1, 1);
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(any, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector<D> stretch;
  for (int k = 0; k < D; ++k) stretch[k] = std::exp(random.uniform(std::log(least), -std::log(least)));
  const Tensor<D> gradient = parts.matrixU() * stretch.asDiagonal() * parts.matrixV().transpose();
  if (gradient.determinant() > 0) return gradient;
  Vector<D> mirrored = Vector<D>::Ones();
  mirrored[0] = -1;
  return mirrored.asDiagonal() * gradient;
}

/// The orthogonal factor changes by 2 / (the two least stretches) times what changes of the gradient, and
/// that are some roundings of its largest.
template <int D>
void check_polar(double least) {
  Random random(31);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Tensor<D> gradient = random_gradient<D>(random, least);
    const Eigen::JacobiSVD<Eigen::MatrixXd> parts(gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::MatrixXd expected = parts.matrixU() * parts.matrixV().transpose();
    const Tensor<D> found = rotation_of(gradient).tensor();
    const Eigen::VectorXd stretch = parts.singularValues();
    const double sensitivity = 2 / (stretch[D - 1] + stretch[D - 2]);
    worst = std::max(worst, (found - expected).norm() / (1 + stretch[0] * sensitivity));
    CHECK((found.transpose() * found).isIdentity(16 * 0x1p-52));
  }
  CHECK(worst <= 32 * 0x1p-52);
}

/// A block and what its outline looked like before it was deformed.
template <int D>
struct Deformed {
  Blocks<D> blocks{memory};
  std::int32_t slot;

  Deformed(const Shape<D>& shape, const Tensor<D>& gradient)
      : slot(blocks.add(shape, BlockKind::affine, 0, 1)) {
    blocks.deform(slot, gradient, Tensor<D>::Zero());
  }
};

int vertex_count(const Outline<2>& outline) { return outline.count; }
int vertex_count(const Outline<3>& outline) { return outline.vertex_count(); }
int halfspace_count(const Outline<2>& outline) { return outline.count; }
int halfspace_count(const Outline<3>& outline) { return outline.face_count(); }

double content_of(const Outline<2>& outline) {
  double twice = 0;
  for (int i = 0; i < outline.count; ++i) twice += cross(outline.vertex(i), outline.vertex(outline.next(i)));
  return twice / 2;
}

/// Tetrahedra from the centroid.
template <class Add>
void for_each_tetrahedron(const Outline<3>& outline, Add add) {
  const Topology& t = *outline.topology;
  for (int f = 0; f < t.face_count; ++f) {
    const int first = t.first_of_face[f];
    for (int k = first + 1; k + 1 < t.first_of_face[f + 1]; ++k)
      add(outline.vertex(t.face_vertex[first]), outline.vertex(t.face_vertex[k]),
          outline.vertex(t.face_vertex[k + 1]));
  }
}

double content_of(const Outline<3>& outline) {
  double sum = 0;
  for_each_tetrahedron(outline, [&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    sum += p.dot(cross_product(q, r)) / 6;
  });
  return sum;
}

template <int D>
void check_outline() {
  Random random(32);
  for (int i = 0; i < 200; ++i) {
    const Shape<D> shape = random_shape<D>(random);
    const Tensor<D> gradient = random_gradient<D>(random, 0.5);
    const Deformed<D> deformed(shape, gradient);
    const Outline<D> now = deformed.blocks.outline(deformed.slot), own = shape.outline();
    for (int v = 0; v < vertex_count(now); ++v)
      CHECK((now.vertex(v) - gradient * own.vertex(v)).norm() <= 8 * 0x1p-52);
    for (int h = 0; h < halfspace_count(now); ++h) {
      CHECK(std::abs(now.normal(h).norm() - 1) <= 4 * 0x1p-52);
      double support = -HUGE_VAL;
      for (int v = 0; v < vertex_count(now); ++v)
        support = std::max(support, now.normal(h).dot(now.vertex(v)));
      // The shape's own normals and offsets are some roundings off its vertices, and the stretch is 2 at
      // most.
      CHECK(std::abs(now.offset[h] - support) <= 128 * 0x1p-52);
    }
    CHECK(content_of(now) == Approx(gradient.determinant() * content_of(own)).epsilon(1e-13));
  }
}

/// The mean of x x^T over a simplex with one corner at the origin: each pair of corners counts, each corner
/// with itself twice (exact for products of two linear functions).
template <int D>
Tensor<D> moment_of_simplex(double content, const std::vector<Vector<D>>& corners) {
  Tensor<D> sum = Tensor<D>::Zero();
  for (const Vector<D>& p : corners) {
    sum += p * p.transpose();
    for (const Vector<D>& q : corners) sum += p * q.transpose();
  }
  return content / ((D + 1) * (D + 2)) * sum;
}

Tensor<2> second_moment_by_simplices(const Outline<2>& o) {
  Tensor<2> sum = Tensor<2>::Zero();
  for (int i = 0; i < o.count; ++i) {
    const Vector<2> p = o.vertex(i), q = o.vertex(o.next(i));
    sum += moment_of_simplex<2>(cross(p, q) / 2, {p, q});
  }
  return sum;
}

Tensor<3> second_moment_by_simplices(const Outline<3>& o) {
  Tensor<3> sum = Tensor<3>::Zero();
  for_each_tetrahedron(o, [&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    sum += moment_of_simplex<3>(p.dot(cross_product(q, r)) / 6, {p, q, r});
  });
  return sum;
}

template <int D>
void check_mass_matrix() {
  Random random(33);
  constexpr double density = 2500;
  for (int i = 0; i < 200; ++i) {
    const Shape<D> shape = random_shape<D>(random);
    Blocks<D> blocks(memory);
    const std::int32_t slot = blocks.add(shape, BlockKind::affine, 0, density);
    const Deformation<D>& deformation = blocks.deformation(std::size_t(slot));
    const Tensor<D> expected = density * second_moment_by_simplices(shape.outline());
    CHECK((deformation.mass_matrix - expected).norm() <= 1e-13 * expected.norm());
    CHECK(deformation.volume == Approx(content_of(shape.outline())).epsilon(1e-13));
    const Eigen::JacobiSVD<Eigen::MatrixXd> parts(expected);
    CHECK(deformation.min_moment == Approx(parts.singularValues()[D - 1]).epsilon(1e-12));
    // Accelerations of points by forces on them: none more than the mobility, and one as much.
    double most = 0;
    for (int v = 0; v < vertex_count(shape.outline()); ++v) {
      const Vector<D> point = shape.outline().vertex(v), force = Vector<D>::Unit(i % D);
      const Tensor<D> acceleration = (force * point.transpose()) * expected.inverse();
      most = std::max(most, (acceleration * point).dot(force));
    }
    CHECK(deformation.strain_mobility == Approx(most).epsilon(1e-12));
    const double condition = parts.singularValues()[0] / parts.singularValues()[D - 1];
    CHECK((deformation.mass_matrix * deformation.inverse_mass_matrix - Tensor<D>::Identity()).norm() <=
          16 * condition * 0x1p-52);
  }
}

/// By the definitions, as integrals over the block.
template <int D>
void check_motion() {
  Random random(34);
  for (int i = 0; i < 50; ++i) {
    const Shape<D> shape = random_shape<D>(random);
    Blocks<D> blocks(memory);
    const std::int32_t slot = blocks.add(shape, BlockKind::affine, 0, 1);
    const Tensor<D> gradient = random_gradient<D>(random, 0.5), rate = random_gradient<D>(random, 0.5);
    blocks.deform(slot, gradient, rate);
    const Deformation<D>& now = blocks.deformation(std::size_t(slot));
    // Integrals of rate X (gradient X)^T and of (rate X)^2.
    const Tensor<D> moments = second_moment_by_simplices(shape.outline());
    const Tensor<D> flow = rate * moments * gradient.transpose();
    CHECK((now.angular_momentum() - moment(flow)).norm() <= 1e-13 * flow.norm());
    CHECK((blocks.momentum[std::size_t(slot)] - moment(flow)).norm() <= 1e-13 * flow.norm());
    CHECK(now.kinetic_energy() == Approx(0.5 * (rate * moments * rate.transpose()).trace()).epsilon(1e-13));
    // Spin and strain rate are the velocity gradient, taken apart.
    const Tensor<D> whole = cross_tensor(blocks.spin[std::size_t(slot)]) + now.strain_rate;
    CHECK((whole * gradient - rate).norm() <= 64 * 0x1p-52 * 4);
    CHECK((now.strain_rate - now.strain_rate.transpose()).norm() == 0);
  }
}

}  // namespace

TEST_CASE("the rotation of a gradient is its orthogonal polar factor") {
  for (const double least : {0.999, 0.5, 0.01}) {
    check_polar<2>(least);
    check_polar<3>(least);
  }
}

TEST_CASE("a deformed outline has unit normals, offsets that touch its vertices, and det times the content") {
  check_outline<2>();
  check_outline<3>();
}

TEST_CASE("the mass matrix is density times the integral of X X^T") {
  check_mass_matrix<2>();
  check_mass_matrix<3>();
}

TEST_CASE("momentum, energy, spin and strain rate are those of the block's points") {
  check_motion<2>();
  check_motion<3>();
}

TEST_CASE("Hooke's law and its inverse") {
  Random random(35);
  for (int i = 0; i < 100; ++i) {
    Elasticity elasticity;
    elasticity.shear_modulus = random.uniform(0.5, 2);
    elasticity.lame = random.uniform(-0.3, 5) * elasticity.shear_modulus;
    const Tensor<3> any = random_gradient<3>(random, 0.5), strain = any + any.transpose();
    const Tensor<3> stress = elasticity.stress<3>(strain);
    CHECK((elasticity.strain<3>(stress) - strain).norm() <= 1e-14 * strain.norm());
    // Twice the energy per volume, of which no strain has more.
    CHECK(strain.cwiseProduct(stress).sum() <= elasticity.largest_stiffness<3>() * strain.squaredNorm());
  }
  Elasticity stiff_in_volume;
  stiff_in_volume.shear_modulus = 1;
  stiff_in_volume.lame = 3;
  CHECK(Tensor<3>::Identity().cwiseProduct(stiff_in_volume.stress<3>(Tensor<3>::Identity())).sum() ==
        3 * stiff_in_volume.largest_stiffness<3>());
}
