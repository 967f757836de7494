// The gain where a touch ends inside of a step: two bars that meet, next to a scheme that sees touches
// at the ends of steps alone.

#include "catch.h"
#include "validation/reacting.h"

namespace {

using namespace halfspace_test;

constexpr int cells = 10;  // of a bar of 1 m
constexpr double size = 1.0 / cells, density = 1000, young = 1e9, speed = 0.01;
constexpr double end = 0.004;  // s; waves run through a bar in 1 ms, and bars part after 2

using Places = std::vector<double>;

/// The nodes of both bars along a line, by this library.
Places by_library(double gap, double time_step) {
  hs_world_def def = mesh_world_def(2);
  def.time_step = time_step;
  ReactingScene scene(def, law_without_spring(), density, {young, 0});
  const MeshWords words = brick(2, {1, size, size}, {cells, 1, 1}, [](int) { return HS_CELL_QUAD; });
  const hs_body striker = scene.add_mesh(words, {-1 - gap, 0, 0}, {speed, 0, 0});
  const hs_body struck = scene.add_mesh(words, {0, 0, 0});
  scene.step(std::llround(end / time_step));
  Places places;
  for (const hs_body body : {striker, struck})
    for (const Node& node : scene.positions(body))
      if (node.y() < size / 2) places.push_back(node.x());
  return places;
}

/// The same bars as rows of masses and springs, by velocity Verlet. Two ends that are found to have met move
/// on together, as their momenta make them, for as long as that takes pressure.
class EndsOfSteps {
 public:
  explicit EndsOfSteps(double gap) {
    for (const double start : {-1 - gap, 0.0})
      for (int i = 0; i <= cells; ++i) {
        places_.push_back(start + i * size);
        velocities_.push_back(start < 0 ? speed : 0);
        masses_.push_back((i == 0 || i == cells ? 0.5 : 1) * density * size);
      }
  }

  Places run(double time_step) {
    Places force = forces();
    for (long i = std::lround(end / time_step); i > 0; --i) {
      for (std::size_t k = 0; k < places_.size(); ++k) {
        velocities_[k] += 0.5 * time_step * force[k] / masses_[k];
        places_[k] += time_step * velocities_[k];
      }
      if (places_[tip] > places_[struck] && !are_together_) {
        are_together_ = true;
        velocities_[tip] = velocities_[struck] = 0.5 * (velocities_[tip] + velocities_[struck]);
      }
      force = forces();
      for (std::size_t k = 0; k < places_.size(); ++k)
        velocities_[k] += 0.5 * time_step * force[k] / masses_[k];
    }
    return places_;
  }

 private:
  static constexpr std::size_t tip = cells, struck = cells + 1;

  Places forces() {
    Places force(places_.size(), 0);
    for (std::size_t k = 0; k + 1 < places_.size(); ++k) {
      if (k == tip) continue;
      const double pull = young * (places_[k + 1] - places_[k] - size) / size;
      force[k] += pull;
      force[k + 1] -= pull;
    }
    if (are_together_) {
      const double pressure = 0.5 * (force[tip] - force[struck]);
      are_together_ = pressure > 0;
      if (are_together_) force[tip] = force[struck] = 0.5 * (force[tip] + force[struck]);
    }
    return force;
  }

  Places places_, velocities_, masses_;
  bool are_together_ = false;
};

double largest_difference(const Places& a, const Places& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

/// Bars that swing after the impact are off by their waves, too, to the second order in the step: near the
/// critical step that is more than what the touch makes.
TEST_CASE("two stages in a step make places after an impact more accurate", "[mesh][reaction]") {
  const double critical = size / std::sqrt(young / density);
  constexpr int phases = 4;
  std::vector<double> ratios;
  for (const int parts : {2, 8, 32}) {
    const double step = critical / parts, fine = critical / 512;
    double with = 0, without = 0;
    for (int phase = 0; phase < phases; ++phase) {
      const double gap = speed * (1e-3 + phase * step / phases);
      const Places exact = by_library(gap, fine), likewise = EndsOfSteps(gap).run(fine);
      with += std::pow(largest_difference(by_library(gap, step), exact), 2) / phases;
      without += std::pow(largest_difference(EndsOfSteps(gap).run(step), likewise), 2) / phases;
    }
    ratios.push_back(std::sqrt(without / with));
    std::printf(
        "places after an impact at 1/%d of the critical step: %.1e of the way off, %.1e by the ends of "
        "steps, "
        "%.1f times\n",
        parts, std::sqrt(with) / (speed * end), std::sqrt(without) / (speed * end), ratios.back());
  }
  CHECK(ratios[0] > 2);
  CHECK(ratios[1] > 20);
  CHECK(ratios[2] > 200);
}
