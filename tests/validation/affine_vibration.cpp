// Free vibration of affine blocks in each of their modes, its damping, and the step up to which it is stable.

#include "catch.h"
#include "validation/affine.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2000;
constexpr double amplitude = 1e-6;         // of the strain: what is not linear is that share of what is
const hs_law_def soft = spring_law(1e-3);  // nothing touches: contacts must not take part in the stable step

/// A box that strains by a displacement gradient G of this shape, and vibrates at this frequency: M the mass
/// matrix, V the volume, M_kk G_ik'' = -V (lame tr G 1 + 2 mu sym G)_ik.
struct Mode {
  const char* name;
  Tensor shape;
  double frequency;
};

/// Stretches: V (lame 1 1^T + 2 mu I) g = omega^2 M g for the diagonal of G. Shear of two axes: omega^2 = V
/// mu (1 / M_ii + 1 / M_kk), and no angular momentum, so that G_ik M_kk = G_ki M_ii.
std::vector<Mode> modes_of_box(int dimension, const Triple& sides, const Elastic& elastic) {
  const Eigen::VectorXd mass = mass_matrix_of_box(density, sides).head(dimension);
  const double volume = sides[0] * sides[1] * sides[2];
  std::vector<Mode> modes;
  const Eigen::MatrixXd stiffness =
      volume * (elastic.lame() * Eigen::MatrixXd::Ones(dimension, dimension) +
                2 * elastic.shear() * Eigen::MatrixXd::Identity(dimension, dimension));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> stretches(
      stiffness, mass.asDiagonal().toDenseMatrix());
  for (int m = 0; m < dimension; ++m) {
    Mode mode{"stretch", Tensor::Zero(), std::sqrt(stretches.eigenvalues()[m])};
    mode.shape.diagonal().head(dimension) = stretches.eigenvectors().col(m).normalized();
    modes.push_back(mode);
  }
  for (int i = 0; i < dimension; ++i) {
    for (int k = 0; k < i; ++k) {
      Mode mode{"shear", Tensor::Zero(), std::sqrt(volume * elastic.shear() * (1 / mass[i] + 1 / mass[k]))};
      mode.shape(i, k) = mass[i] / std::hypot(mass[i], mass[k]);
      mode.shape(k, i) = mass[k] / std::hypot(mass[i], mass[k]);
      modes.push_back(mode);
    }
  }
  return modes;
}

/// A box in a world of its own, strained by a mode's shape and let go.
struct Vibration {
  SolidScene scene;
  hs_block block = 0;
  Tensor shape;

  Vibration(hs_world_def def, const Triple& sides, const Elastic& elastic, const Mode& mode)
      : scene(def, soft, density), shape(mode.shape) {
    set_elastic(scene, elastic);
    if (def.dimension == 2) {
      block = scene.add(rectangle(sides[0], sides[1]), {HS_BLOCK_AFFINE, {}, 0});
    } else {
      block = scene.add_hull(cuboid(sides), {{}, {0, 0, 0, 1}, HS_BLOCK_AFFINE, {}, {}});
    }
    deform(scene, block, Tensor::Identity() + amplitude * shape, Tensor::Zero());
  }
  double step() {
    scene.step();
    return place();
  }
  /// How much of the mode's shape the block has now.
  double place() const { return (gradient_of(scene, block) - Tensor::Identity()).cwiseProduct(shape).sum(); }
};

hs_world_def still_world(int dimension, double time_step) {
  hs_world_def def = solid_world_def(time_step, {0, 0, 0});
  def.dimension = dimension;
  return def;
}

constexpr int periods = 20;

double measured_period(Vibration vibration, double time_step) {
  double before = vibration.place(), first = 0, last = 0;
  for (int crossings = 0, step = 1; crossings < 2 * periods + 1; ++step) {
    const double place = vibration.step();
    if ((before > 0) != (place > 0)) {
      last = (step - 1 + before / (before - place)) * time_step;
      if (crossings++ == 0) first = last;
    }
    before = place;
  }
  return (last - first) / periods;
}

/// Verlet's frequency is 2/dt asin(omega dt/2), so that the period is short by (omega dt)^2 / 24. The chord
/// of the step in which the sine passes zero misses that by (omega dt)^3 / 62 at most, at both ends. What is
/// not linear moves a zero by a share of the amplitude; n steps each round the gradient.
void check_period(int dimension, const char* what, const Triple& sides, const Elastic& elastic,
                  const Mode& mode) {
  const double period = 2 * pi / mode.frequency;
  for (const double turn : {0.2, 0.1, 0.05}) {
    const double time_step = turn / mode.frequency;
    const double measured =
        measured_period(Vibration(still_world(dimension, time_step), sides, elastic, mode), time_step);
    const double verlet = turn / (2 * std::asin(turn / 2));
    const double error = measured / period - 1;
    const double steps = periods * 2 * pi / turn;
    const double bound =
        (turn * turn * turn / 31 + 2 * amplitude + steps * rounding / amplitude) / (2 * pi * periods);
    std::printf("vibration, %s, %s at %.1f rad/s, omega dt %.2f: period off by %+.3e, Verlet's by %+.3e\n",
                what, mode.name, mode.frequency, turn, error, verlet - 1);
    CHECK(std::abs(measured / period - verlet) <= bound);
    CHECK(std::abs(error) <= turn * turn / 24 * (1 + turn * turn) + bound);
  }
}

TEST_CASE("a square vibrates at the two frequencies of theory, in plane strain and plane stress") {
  constexpr double side = 2;
  for (const int32_t plane : {HS_PLANE_STRAIN, HS_PLANE_STRESS}) {
    const Elastic elastic{3e9, 0.3, plane};
    const std::vector<Mode> modes = modes_of_box(2, {side, side, 1}, elastic);
    const double inertia = density * side * side;
    // Of the two stretches one is deviatoric, as the shear is.
    const double dilation = 12 * (2 * elastic.lame() + 2 * elastic.shear()) / inertia;
    const double deviatoric = 24 * elastic.shear() / inertia;
    CHECK(modes[0].frequency == Approx(std::sqrt(deviatoric)).epsilon(1e-14));
    CHECK(modes[1].frequency == Approx(std::sqrt(dilation)).epsilon(1e-14));
    CHECK(modes[2].frequency == Approx(std::sqrt(deviatoric)).epsilon(1e-14));
    for (const Mode& mode : modes)
      check_period(2, plane == HS_PLANE_STRESS ? "square, plane stress" : "square, plane strain",
                   {side, side, 1}, elastic, mode);
  }
}

TEST_CASE("a rectangle vibrates at its three frequencies") {
  const Triple sides{3, 0.5, 1};
  const Elastic elastic{1e9, 0.4};
  for (const Mode& mode : modes_of_box(2, sides, elastic)) check_period(2, "rectangle", sides, elastic, mode);
}

TEST_CASE("in space, a box vibrates at its six frequencies") {
  const Triple sides{1, 2, 0.4};
  const Elastic elastic{2e9, 0.2};
  for (const Mode& mode : modes_of_box(3, sides, elastic)) check_period(3, "box", sides, elastic, mode);
}

/// Of x' = x + dt v', v' = v - dt (omega^2 x + gamma v), the motion with its damping read half a step late,
/// the determinant is 1 - gamma dt: what x_n x_{n+2} - x_{n+1}^2 is multiplied by in each step.
double measured_damping(Vibration vibration, double time_step, int steps) {
  const auto determinant = [&] {
    const double x = vibration.place(), y = vibration.step(), z = vibration.step();
    return x * z - y * y;
  };
  vibration.step();  // begins with velocities that are not late
  const double first = determinant();
  for (int i = 2; i < steps; ++i) vibration.step();
  return -std::log(determinant() / first) / (steps * time_step);
}

/// gamma = beta omega^2 + c for Rayleigh's beta and damping c of the mass. The rate of decay, half of that,
/// is off by gamma dt / 2 for the velocities that are late. The determinant is a difference of (omega dt)^2
/// of its terms, which has to do with places rounded in n steps, and what is not linear.
TEST_CASE("vibration decays at the rate of theory") {
  const Elastic undamped{1e9, 0.25};
  for (const int dimension : {2, 3}) {
    const Triple sides{1, 1, dimension == 2 ? 1 : 0.7};
    for (const Mode& mode : modes_of_box(dimension, sides, undamped)) {
      for (const double share : {0.02, 0.2}) {  // of critical
        for (const bool by_mass : {false, true}) {
          const double turn = 0.02, time_step = turn / mode.frequency;
          const double rate = 2 * share * mode.frequency;
          Elastic elastic = undamped;
          hs_world_def def = still_world(dimension, time_step);
          if (by_mass) {
            def.mass_damping = rate;
          } else {
            elastic.damping_time = rate / square_of(mode.frequency);
          }
          const int steps = int(1 / (share * turn));  // to 1/e
          const double measured = measured_damping(Vibration(def, sides, elastic, mode), time_step, steps);
          const double late = -std::log(1 - rate * time_step) / time_step;
          const double bound = (steps * rounding / amplitude + 2 * amplitude) / (turn * turn) * share;
          std::printf(
              "decay, %dD %s, %.2f of critical by %s: rate %.6f of theory, with late velocities %.6f\n",
              dimension, mode.name, share, by_mass ? "mass" : "strain rate", measured / rate, late / rate);
          CHECK(std::abs(measured / late - 1) <= bound);
          CHECK(std::abs(measured / rate - 1) <= 0.51 * rate * time_step + bound);
        }
      }
    }
  }
}

/// Free of contacts, with a law so soft that it counts for nothing: the step is bounded by the block alone.
struct Shaken {
  const char* name;
  int dimension;
  Corners corners;
};

/// The largest strain energy of a run, over all the energy that the block had; infinite if it got out of
/// hand.
double largest_energy(const Shaken& shaken, double share, int steps) {
  const auto make = [&](double time_step) {
    SolidScene scene(still_world(shaken.dimension, time_step), soft, density);
    set_elastic(scene, {1e9, 0.25});
    Points points;
    for (const Triple& c : shaken.corners) points.push_back({c[0], c[1]});
    const hs_block block = shaken.dimension == 2
                               ? scene.add(points, {HS_BLOCK_AFFINE, {}, 0})
                               : scene.add_hull(shaken.corners, {{}, {0, 0, 0, 1}, HS_BLOCK_AFFINE, {}, {}});
    Tensor strain;
    strain << 3, 1, -1, 1, -2, 2, -1, 2, 4;  // of all modes
    deform(scene, block, Tensor::Identity() + amplitude * strain, Tensor::Zero());
    return scene;
  };
  const double stable = make(0).report().stable_time_step;
  SolidScene scene = make(share * stable);
  const double before = scene.report().block_strain_energy;
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    if (hs_world_step(scene.world(), 1) != HS_OK) return HUGE_VAL;
    largest = std::max(largest, scene.report().block_strain_energy);
  }
  return largest / before;
}

/// Leapfrog at the share q of the stable step of a mode keeps (1 - q^2) omega^2 x^2 + v^2, so that of a block
/// that begins at rest each mode's strain energy is largest then. The stable step reported is no more than
/// that of the fastest mode; for a square, whose dilation is as stiff as any strain, just that.
TEST_CASE("blocks vibrate on at 0.95 of the stable step reported, however thin") {
  const auto flat = [](const Points& points) {
    Corners corners;
    for (const Point& p : points) corners.push_back({p.x, p.y, 0});
    return corners;
  };
  const Shaken all[] = {{"square", 2, flat(rectangle(1, 1))},
                        {"sliver 1:100", 2, flat(rectangle(1, 0.01))},
                        {"triangle 1:100", 2, flat({{0, 0}, {1, 0}, {0.7, 0.01}})},
                        {"cube", 3, cuboid({1, 1, 1})},
                        {"plate 1:100", 3, cuboid({1, 1, 0.01})},
                        {"needle 1:100", 3, cuboid({1, 0.01, 0.01})},
                        {"splinter", 3, {{0, 0, 0}, {1, 0, 0}, {0.9, 0.01, 0}, {0.5, 0, 0.02}}}};
  for (const Shaken& shaken : all) {
    const double largest = largest_energy(shaken, 0.95, 100000);
    std::printf("stable step, %s: strain energy at most %.6f of the first at 0.95 of it\n", shaken.name,
                largest);
    // What is not linear makes a difference of some times the amplitude.
    CHECK(largest <= 1 + 100 * amplitude);
  }
  const double above = largest_energy(all[0], 1.01, 20000);
  std::printf("stable step, square: strain energy %.1e of the first at 1.01 of it\n", above);
  CHECK(above > 1e3);
}

/// Of blocks that stand on one another, contacts and strain count together. Set down free of strain they
/// bounce in their weights, with all of the weight's work at first; dashpots and viscosity take that, unless
/// a step too long makes as much or more.
TEST_CASE("stacks of affine blocks come to rest at 0.95 of the stable step reported") {
  constexpr double height = 0.1;
  constexpr int count = 4;
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
    for (const double width : {0.1, 2.0}) {
      hs_law_def law = spring_law(1e9, 0.5);
      law.stiffness_kind = kind;
      law.normal_damping = law.shear_damping = 0.2;
      hs_world_def def = world_def(0);
      def.safety = 0.95;
      Scene scene(def, law, density);
      set_elastic(scene, {1e8, 0.25, HS_PLANE_STRAIN, 1e-5});
      scene.add(box(-3, -1, 3, 0), {HS_BLOCK_FIXED, {}, 0});
      for (int i = 0; i < count; ++i)
        scene.add(box(0, height * i, width, height * (i + 1)), {HS_BLOCK_AFFINE, {}, 0});
      const hs_world_report first = scene.report();
      scene.step(100000);
      const hs_world_report last = scene.report();
      const double weight = count * density * width * height * 9.81;
      // The way that the weight goes down: its work is what there was to be taken.
      const double work = first.energy.gravity - last.energy.gravity;
      std::printf(
          "stable step, stack of %d blocks 1:%.0f, law %d: after 1e5 steps of %.2e s kinetic energy %.1e of "
          "the "
          "work of the weight, which went down by %.1e of the height\n",
          count, width / height, kind, last.time_step, last.energy.kinetic / work,
          work / weight / (count * height));
      CHECK(last.time_step == 0.95 * first.stable_time_step);
      CHECK(work > 0);
      CHECK(last.energy.kinetic <= 1e-2 * work);
    }
  }
}

}  // namespace
