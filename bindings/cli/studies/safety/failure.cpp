#include "studies/safety/failure.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

constexpr double farthest = 0.1;  ///< of the size of a block, the largest limit

/// The largest distance of a vertex from the first one.
double size_of(const BlockFrame& block) {
  double size = 0;
  for (const Point& p : block.vertices) size = std::max(size, length(minus(p, block.vertices[0])));
  return size;
}

/// The elastic shear displacement of a contact before it slips, and the compression of its normal spring, m.
double yield_of(const hs_contact& contact, const hs_law_def& law) {
  if (!has_spring(law)) return 0;
  const double shear = (law.shear_stiffness > 0 ? law.shear_stiffness : law.normal_stiffness) *
                       shear_per_face(law.stiffness_kind, contact.area);
  const double limit =
      std::tan(law.friction_angle) * std::max(contact.normal_force, 0.0) + law.cohesion * contact.area;
  return (shear > 0 ? limit / shear : 0) + std::max(-contact.gap, 0.0);
}

/// The same of a bond, and its opening before it fails. With a fracture energy it fails after a longer
/// displacement, over which its strength decreases.
double yield_of(const hs_bond& bond, const hs_bond_def& def) {
  if (bond.area == 0) return 0;
  const auto until_failure = [](double strength, double stiffness, double energy) {
    return strength > 0 ? std::max(strength / stiffness, 2 * energy / strength) : 0;
  };
  const double pressure = std::max(-bond.normal_force, 0.0) / bond.area;
  const double shear_stiffness = def.shear_stiffness > 0 ? def.shear_stiffness : def.normal_stiffness;
  return until_failure(def.cohesion + std::tan(def.friction_angle) * pressure, shear_stiffness,
                       def.shear_fracture_energy) +
         until_failure(def.tensile_strength, def.normal_stiffness, def.tensile_fracture_energy) +
         pressure / def.normal_stiffness;
}

/// The elastic displacement of a block by its stress.
double yield_of(const BlockFrame& block, const Material& material) {
  if (!deforms(block.state.kind) || !material.elasticity) return 0;
  double squared = 0;
  for (const double stress : block.deformation.stress) squared += stress * stress;
  return std::sqrt(squared) / material.elasticity->young_modulus * size_of(block);
}

/// The elastic displacement of all joints and bodies, m.
double yield_of(const Scene& scene, const Model& standing, const Frame& frame) {
  const auto material_of = [&](std::size_t block) { return frame.blocks[block].state.material; };
  double yield = 0;
  for (const hs_contact& contact : standing.contacts())
    yield +=
        yield_of(contact, law_between(scene, material_of(contact.block_a), material_of(contact.block_b)));
  for (const hs_bond& bond : standing.bonds()) {
    if (bond.is_joint == 0) continue;
    const auto pair = std::find_if(scene.bonds.begin(), scene.bonds.end(), [&](const PairBond& of) {
      return std::minmax(of.a, of.b) == std::minmax(material_of(bond.block_a), material_of(bond.block_b));
    });
    if (pair != scene.bonds.end()) yield += yield_of(bond, pair->def);
  }
  if (standing.layout().has_deformable()) {
    for (const BlockFrame& block : frame.blocks)
      if (!is_removed(block))
        yield += yield_of(block, scene.materials[static_cast<std::size_t>(block.state.material)]);
  }
  return yield;
}

Point displacement(const BlockFrame& start, const BlockFrame& now) {
  return minus(point_of(now.state.pose.position), point_of(start.state.pose.position));
}

/// The ground moves with the prescribed blocks where no block is fixed, as in an earthquake.
Point displacement_of_ground(const Frame& start, const Frame& now) {
  Point sum{};
  double count = 0;
  for (std::size_t i = 0; i < now.blocks.size(); ++i) {
    if (is_removed(now.blocks[i])) continue;
    if (now.blocks[i].state.kind == HS_BLOCK_FIXED) return {};
    if (now.blocks[i].state.kind != HS_BLOCK_PRESCRIBED) continue;
    sum = plus(sum, displacement(start.blocks[i], now.blocks[i]));
    ++count;
  }
  return count > 0 ? times(1 / count, sum) : sum;
}

}  // namespace

/// A stable block moves by the elastic displacement of the joints and bodies between it and the fixed ground,
/// more if it tilts. Ten times the sum over all of them is beyond that.
std::vector<double> limits_at_rest(const Scene& scene, const Model& standing) {
  constexpr double smallest = 1e-3, times_yield = 10;  // the first of the size of a block
  const Frame frame = standing.frame();
  const double yield = yield_of(scene, standing, frame);
  std::vector<double> limits = limits_at_start(frame);
  for (double& limit : limits) limit = std::clamp(times_yield * yield, smallest / farthest * limit, limit);
  return limits;
}

std::vector<double> limits_at_start(const Frame& start) {
  std::vector<double> limits;
  for (const BlockFrame& block : start.blocks)
    limits.push_back(moves_freely(block.state.kind) ? farthest * size_of(block) : 0);
  return limits;
}

std::vector<double> displacements(const Frame& start, const Frame& now) {
  const Point of_ground = displacement_of_ground(start, now);
  std::vector<double> moved(now.blocks.size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (!is_removed(now.blocks[i]) && moves_freely(now.blocks[i].state.kind))
      moved[i] = length(minus(displacement(start.blocks[i], now.blocks[i]), of_ground));
  }
  return moved;
}

std::string failed_blocks(const Layout& layout, const std::vector<double>& moved,
                          const std::vector<double>& limits) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (!(moved[i] > limits[i])) continue;
    if (count++ == 0 || moved[i] > moved[first]) first = i;
  }
  if (count == 0) return {};
  return std::to_string(count) + " of " + std::to_string(moved.size()) + " blocks, " +
         layout.blocks[first].name + " by " + rounded(moved[first], 3) + " m";
}

}  // namespace halfspace::cli
