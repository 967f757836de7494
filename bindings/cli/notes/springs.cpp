#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/text.h"
#include "common/vector.h"
#include "notes/kinds.h"
#include "notes/loads.h"

namespace halfspace::cli {
namespace {

/// The springs between two blocks.
class Springs {
 public:
  Springs(const Scene& scene, const Model& model) : scene_(scene), length_(model.report().potential_length) {}

  /// The stiffness of two aligned faces over the mean cross section of the smaller block, N/m.
  double stiffness(const Body& a, const Body& b) const {
    const hs_law_def& law = law_between(scene_, a.state.material, b.state.material);
    const double section = std::min(a.volume / a.thickness, b.volume / b.thickness);
    if (has_no_spring(law)) return HUGE_VAL;  // no penetration
    return law.normal_stiffness * normal_per_face(law.stiffness_kind, section, length_);
  }

 private:
  const Scene& scene_;
  double length_;
};

double inverse_mass(const Body& body) { return moves_freely(body.state.kind) ? 1 / body.state.mass : 0; }

/// The pair with the largest ratio of depth to size.
struct Worst {
  void add(std::size_t one, std::size_t other, double depth, double size) {
    if (!(depth / size > ratio)) return;
    ratio = depth / size;
    block = one;
    partner = other;
    this->depth = depth;
  }
  double ratio = 0, depth = 0;
  std::size_t block = 0, partner = 0;
};

}  // namespace

/// Notes a static penetration of 1 % for a block alone, and of 10 % for one under a pile.
void note_weights(const Start& start, Faults& faults) {
  constexpr double reported_ratio_alone = 0.01, reported_ratio_in_a_pile = 0.1;
  const Point gravity = point_of(start.scene.world.gravity);
  const std::vector<double> loads = loads_of(start.frame, gravity);
  const Springs springs(start.scene, start.model);
  std::vector<std::int64_t> count_of(start.scene.materials.size());
  for (const Body& body : start.bodies) ++count_of[static_cast<std::size_t>(body.state.material)];
  Worst alone, in_a_pile;
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    const Body& body = start.bodies[i];
    if (!moves_freely(body.state.kind)) continue;
    Body base = body;  // a possible base, as wide as the block itself
    for (std::size_t material = 0; material < count_of.size(); ++material) {
      base.state.material = static_cast<int32_t>(material);
      const bool is_alone = base.state.material == body.state.material && count_of[material] == 1;
      if (count_of[material] == 0 || is_alone) continue;
      const double stiffness = springs.stiffness(body, base);
      alone.add(i, i, body.state.mass * length(gravity) / stiffness, body.thickness);
      in_a_pile.add(i, i, loads[i] / stiffness, body.thickness);
    }
  }
  const bool is_pile = in_a_pile.ratio >= reported_ratio_in_a_pile && in_a_pile.ratio > 1.01 * alone.ratio;
  const Worst& worst = is_pile ? in_a_pile : alone;
  if (worst.ratio < reported_ratio_alone) return;
  const LayoutBlock& block = start.layout.blocks[worst.block];
  const std::string cause = is_pile ? "its weight and the weight above it" : "its own weight";
  faults.note(block.place, block.key,
              quoted(block.name) + " sinks into its support by " + rounded(worst.depth, 3) + " m, " +
                  ratio_text(worst.ratio) + " its thickness, under " + cause + "; increase normal_stiffness");
}

void note_speeds(const Start& start, Faults& faults) {
  constexpr double reported_ratio = 0.1;
  const Springs springs(start.scene, start.model);
  Worst worst;
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    if (start.bodies[i].speed == 0 || start.bodies[i].state.kind == HS_BLOCK_MESH) continue;
    for (std::size_t j = 0; j < start.bodies.size(); ++j) {
      const double inverse = inverse_mass(start.bodies[i]) + inverse_mass(start.bodies[j]);
      if (i == j || inverse == 0) continue;
      const Motion &one = start.layout.blocks[i].motion, &other = start.layout.blocks[j].motion;
      if (one.velocity == other.velocity && one.angular_velocity == other.angular_velocity) continue;
      const double depth =
          start.bodies[i].speed / std::sqrt(inverse * springs.stiffness(start.bodies[i], start.bodies[j]));
      worst.add(i, j, depth, std::min(start.bodies[i].thickness, start.bodies[j].thickness));
    }
  }
  if (worst.ratio < reported_ratio) return;
  const LayoutBlock& block = start.layout.blocks[worst.block];
  faults.note(block.place, block.key,
              quoted(block.name) + " at " + rounded(start.bodies[worst.block].speed, 3) +
                  " m/s would penetrate " + quoted(start.layout.blocks[worst.partner].name) + " by " +
                  rounded(worst.depth, 3) + " m, v (m/k)^1/2, " + ratio_text(worst.ratio) +
                  " the thinner one's thickness; increase normal_stiffness");
}

}  // namespace halfspace::cli
