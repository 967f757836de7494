// Stress of affine blocks at rest under loads: Hooke's law, the patch test, a column under its weight, and
// stress in situ.

#include "catch.h"
#include "validation/affine.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2000;
constexpr double young = 1e9;
constexpr double load = 1e3;             // Pa
constexpr double strain = load / young;  // what is not linear is some times that share of what is

/// Without gravity; local damping brings all to rest.
hs_world_def quiet_world(int dimension, double gravity = 0) {
  hs_world_def def = solid_world_def(0, {0, gravity, 0});
  def.dimension = dimension;
  def.local_damping = 0.7;
  return def;
}

Tensor symmetric(double xx, double yy, double xy, double zz = 0, double yz = 0, double zx = 0) {
  Tensor stress;
  stress << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  return stress;
}

/// Small strain by Hooke's law in space; in the plane with the zz that the section asks for.
Tensor hooke(const Elastic& elastic, Tensor stress, int dimension) {
  const double g = 2 * elastic.shear(), e = elastic.young;
  if (dimension == 2 && elastic.plane == HS_PLANE_STRAIN)
    stress(2, 2) = elastic.poisson * (stress(0, 0) + stress(1, 1));
  Tensor out = stress / g - Tensor((1 / g - 1 / e) * stress.trace() * Tensor::Identity());
  // 1 / 2 mu = (1 + nu) / E: the mean takes nu / E of the trace.
  if (dimension == 2) out(2, 2) = 0;
  return out;
}

/// Both differ by twice the strain and some more.
void check_strain(const char* what, const Scene& scene, hs_block block, const Elastic& elastic,
                  const Tensor& stress, int dimension) {
  const hs_deformation now = deformation_of(scene, block);
  const Tensor wanted = hooke(elastic, stress, dimension);
  const double strain_error = (tensor(now.strain) - wanted).norm() / wanted.norm();
  const double stress_error = (tensor(now.stress) - stress).norm() / stress.norm();
  std::printf("%s: strain off by %.1e of Hooke's, stress by %.1e of the load's\n", what, strain_error,
              stress_error);
  CHECK(strain_error <= 10 * strain);
  CHECK(stress_error <= 10 * strain);
}

TEST_CASE("a block under tractions strains by Hooke's law, in plane strain and plane stress") {
  const Points shapes[] = {rectangle(2, 1), {{0, 0}, {2, 0.5}, {1.5, 2}, {0.2, 1.5}, {-0.3, 0.5}}};
  const struct {
    const char* name;
    Tensor stress;
  } loads[] = {{"uniaxial", symmetric(-load, 0, 0)},
               {"biaxial", symmetric(load, -2 * load, 0)},
               {"shear", symmetric(0, 0, load)}};
  for (const int32_t plane : {HS_PLANE_STRAIN, HS_PLANE_STRESS}) {
    for (const Points& shape : shapes) {
      for (const auto& under : loads) {
        const Elastic elastic{young, 0.3, plane};
        Scene scene(quiet_world(2), spring_law(1e6), density);
        set_elastic(scene, elastic);
        const hs_block block = scene.add(shape, {HS_BLOCK_AFFINE, {}, 0});
        load_edges(scene, block, shape, under.stress);
        scene.step(5000);
        char what[100];
        std::snprintf(what, sizeof what, "%s of %zu corners under %s traction",
                      plane == HS_PLANE_STRESS ? "plane stress" : "plane strain", shape.size(), under.name);
        check_strain(what, scene, block, elastic, under.stress, 2);
      }
    }
  }
}

/// Which face of a solid is which tells its own normal.
void load_faces(const SolidScene& scene, hs_block block, const Corners& corners, const Tensor& stress) {
  hs_shape* made = nullptr;
  scene.check(hs_polyhedron_create_hull(
      scene.context(),
      {&corners[0][0], &corners[0][1], &corners[0][2], sizeof(Triple), std::int64_t(corners.size())}, &made));
  const Shape shape(made);
  std::vector<Triple> normals(32);
  std::int64_t count = 0;
  scene.check(hs_shape_get_halfspaces(
      shape.get(), {&normals[0][0], &normals[0][1], &normals[0][2], sizeof(Triple), 32}, nullptr, &count));
  for (std::int64_t f = 0; f < count; ++f) {
    const Triple& n = normals[std::size_t(f)];
    const Eigen::Vector3d traction = stress * Eigen::Vector3d(n[0], n[1], n[2]);
    scene.check(hs_world_add_surface_load(scene.world(), block, int32_t(f), traction.data()));
  }
}

TEST_CASE("in space, a block under tractions strains by Hooke's law") {
  const Corners shapes[] = {cuboid({2, 1, 0.5}), {{0, 0, 0}, {1, 0, 0.1}, {0.2, 1, 0}, {0.3, 0.4, 1}}};
  const struct {
    const char* name;
    Tensor stress;
  } loads[] = {{"uniaxial", symmetric(-load, 0, 0)},
               {"triaxial", symmetric(load, -2 * load, 0, 3 * load)},
               {"shear", symmetric(0, 0, load, 0, 2 * load, -load)}};
  const Elastic elastic{young, 0.3};
  for (const Corners& shape : shapes) {
    for (const auto& under : loads) {
      SolidScene scene(quiet_world(3), spring_law(1e6), density);
      set_elastic(scene, elastic);
      const hs_block block = scene.add_hull(shape, {{}, {0, 0, 0, 1}, HS_BLOCK_AFFINE, {}, {}});
      load_faces(scene, block, shape, under.stress);
      scene.step(5000);
      char what[100];
      std::snprintf(what, sizeof what, "solid of %zu corners under %s traction", shape.size(), under.name);
      check_strain(what, scene, block, elastic, under.stress, 3);
    }
  }
}

/// Loads those edges of a block that lie on the outline of a rectangle about the origin.
void load_outer_edges(const Scene& scene, hs_block block, const Points& vertices, double half_width,
                      double half_height, const Tensor& stress) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point p = vertices[i], q = vertices[(i + 1) % vertices.size()];
    Eigen::Vector3d normal(0, 0, 0);
    if (std::abs(p.x) == half_width && p.x == q.x) normal.x() = p.x / half_width;
    if (std::abs(p.y) == half_height && p.y == q.y) normal.y() = p.y / half_height;
    const Eigen::Vector3d traction = stress * normal;
    scene.check(hs_world_add_surface_load(scene.world(), block, int32_t(i), traction.data()));
  }
}

/// A rectangle in blocks, pressed from all sides with a stress that its joints can carry, has that stress in
/// every block. Joints give way by load / stiffness, and put the contact's points off by that: `give` of a
/// block's size. Where four corners meet, those across touch over no more than that; but a spring of the
/// whole contact is as stiff there as elsewhere, and takes its share.
TEST_CASE("the patch test: blocks pressed together all have the stress applied") {
  constexpr double give = 1e-6, stiffness = load / give;
  const struct {
    const char* name;
    std::vector<Points> blocks;
    Tensor stress;
    double friction;
  } patches[] = {
      {"four rectangles",
       {box(-1, -1, 0.25, 0.5), box(0.25, -1, 1, 0.5), box(-1, 0.5, 0.25, 1), box(0.25, 0.5, 1, 1)},
       symmetric(-load, -2 * load, 0),
       0},
      {"two blocks, slanted joint without friction",
       {{{-1, -1}, {1, -1}, {1, 0.4}, {-1, -0.3}}, {{-1, -0.3}, {1, 0.4}, {1, 1}, {-1, 1}}},
       symmetric(-load, -load, 0),
       0},
      {"two blocks, slanted joint with friction",
       {{{-1, -1}, {1, -1}, {1, 0.4}, {-1, -0.3}}, {{-1, -0.3}, {1, 0.4}, {1, 1}, {-1, 1}}},
       symmetric(-load / 2, -load, 0),
       60 * degree}};
  for (const auto& patch : patches) {
    for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
      if (kind == HS_STIFFNESS_PER_CONTACT && patch.blocks.size() > 2) continue;
      hs_law_def law = spring_law(stiffness, patch.friction);
      law.stiffness_kind = kind;
      Scene scene(quiet_world(2), law, density);
      set_elastic(scene, {young, 0.25});
      std::vector<hs_block> blocks;
      for (const Points& vertices : patch.blocks) {
        blocks.push_back(scene.add(vertices, {HS_BLOCK_AFFINE, {}, 0}));
        load_outer_edges(scene, blocks.back(), vertices, 1, 1, patch.stress);
      }
      scene.step(40000);
      double worst = 0;
      for (const hs_block block : blocks)
        worst = std::max(worst, (stress_of(scene, block) - patch.stress).norm() / patch.stress.norm());
      std::printf("patch test, %s, law %d: stress off by at most %.1e of the stress applied\n", patch.name,
                  kind, worst);
      CHECK(worst <= 10 * (give + strain));
    }
  }
}

/// The mean stress of a block of a column is the weight above its middle. Joints and floor give way by a
/// share of a block's size that is added to the strain.
TEST_CASE("in a column under its weight each block has the stress of the weight above its middle") {
  constexpr int count = 5;
  constexpr double gravity = 9.81, weight = density * gravity;  // of a block of 1 m
  constexpr double stiff = 1e11, give = count * weight / stiff;
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
    hs_law_def law = spring_law(stiff, 0.5);
    law.stiffness_kind = kind;
    Scene scene(quiet_world(2, -gravity), law, density);
    set_elastic(scene, {stiff, 0.25});
    scene.add(box(-5, -1, 5, 0), {HS_BLOCK_FIXED, {}, 0});
    std::vector<hs_block> blocks;
    for (int i = 0; i < count; ++i)
      blocks.push_back(scene.add(box(0, i, 1, i + 1), {HS_BLOCK_AFFINE, {}, 0}));
    scene.step(60000);
    for (int i = 0; i < count; ++i) {
      const Tensor stress = stress_of(scene, blocks[std::size_t(i)]);
      const double wanted = -weight * (count - i - 0.5);
      std::printf("column, law %d, block %d: stress %.6e, theory %.6e, off by %+.1e; across %.1e\n", kind, i,
                  stress(1, 1), wanted, stress(1, 1) / wanted - 1, stress(0, 0));
      CHECK(std::abs(stress(1, 1) / wanted - 1) <= 10 * give);
      CHECK(std::abs(stress(0, 0)) <= 10 * give * weight * count);
    }
  }
}

/// Whatever the loads leave is rounding, of the load and of the stress: it moves the block by rounding times
/// the load's own strain, and that moves a component of the gradient, which is near 1, by one rounding or
/// none in a step.
TEST_CASE("stress in situ that is in equilibrium with the loads stays, and the block with it") {
  const Points shape{{0, 0}, {2, 0.5}, {1.5, 2}, {0.2, 1.5}, {-0.3, 0.5}};
  const Tensor stress = symmetric(-3e6, -1e6, 5e5);
  hs_world_def def = quiet_world(2);
  def.local_damping = 0;
  Scene scene(def, spring_law(1e6), density);
  set_elastic(scene, {young, 0.25});
  const hs_block block = scene.add(shape, {HS_BLOCK_AFFINE, {}, 0});
  scene.check(hs_world_set_stress(scene.world(), block, stress.data()));
  load_edges(scene, block, shape, stress);
  const double error = (stress_of(scene, block) - stress).norm() / stress.norm();
  const hs_world_report before = scene.report();
  scene.step(10000);
  const double moved = (gradient_of(scene, block) - Tensor::Identity()).cwiseAbs().maxCoeff();
  const double changed = (stress_of(scene, block) - stress).norm() / stress.norm();
  std::printf(
      "in situ: stress off by %.1e at first, by %.1e after 10000 steps, gradient by %.1e; strain energy %.6e "
      "and %.6e J\n",
      error, changed, moved, before.block_strain_energy, scene.report().block_strain_energy);
  CHECK(error <= 8 * rounding);
  CHECK(moved <= 8 * rounding);
  CHECK(changed <= 8 * rounding * young / stress.norm() * 4);
}

/// A bonded beam of three squares, the first one held, the last one pulled across. What the bonds carry at
/// both ends of the middle one, couples included, gives it the mean stress of the beam: shear force over
/// height.
TEST_CASE("a bonded beam has the shear stress of its load, and bending it keeps the energy") {
  constexpr double force = 1000;
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    hs_law_def law = spring_law(1e9, 0.5);
    law.stiffness_kind = kind;
    law.cohesion = law.tensile_strength = 1e12;
    double residual[2];
    for (const bool is_fine : {false, true}) {
      hs_world_def def = world_def(is_fine ? 5e-5 : 1e-4, 0);
      Scene scene(def, law, 1000);
      set_elastic(scene, {.young = 1e8});
      scene.add(box(0, 0, 1, 1), {HS_BLOCK_FIXED, {}, 0});
      const hs_block middle = scene.add(box(1, 0, 2, 1), {HS_BLOCK_AFFINE, {}, 0});
      const hs_block last = scene.add(box(2, 0, 3, 1));
      scene.apply(last, {0, force});
      // The mean over the swings about equilibrium: the load is applied at once, and nothing damps.
      double shear = 0, largest = 0;
      const int steps = is_fine ? 40000 : 20000;
      for (int i = 0; i < steps; ++i) {
        scene.step();
        shear += stress_of(scene, middle)(0, 1) / steps;
        largest = std::max(largest, std::abs(scene.energy().residual));
      }
      const double work = scene.energy().outer_work;
      residual[is_fine] = largest;
      std::printf(
          "bonded beam, %s, step %.0e: mean shear stress %.2f of %.0f Pa, residual %.1e J, work %.2e J\n",
          kind == HS_STIFFNESS_PER_AREA ? "per area" : "per contact", def.time_step, shear, force, largest,
          work);
      // Of some hundred swings the last one may be cut off: a hundredth, twice the mean at its top.
      CHECK(std::abs(shear / force - 1) <= 0.02);
    }
    // Of second order in the step: a quarter, were there nothing else.
    CHECK(residual[1] <= residual[0] / 3);
  }
}

}  // namespace
