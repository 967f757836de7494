#pragma once

#include "block/blocks.h"
#include "world/loads/actions.h"
#include "world/loads/bolts.h"
#include "world/loads/viscous_nodes.h"
#include "world/loads/water.h"
#include "world/model/materials.h"
#include "world/model/settings.h"

namespace halfspace {

/// Settings, materials, blocks and loads of a world. The parts of the world read them and move the blocks.
template <int D>
struct Model {
  Model(const WorldSettings<D>& given, Memory* memory)
      : settings(given),
        materials(memory),
        blocks(memory),
        actions(memory),
        viscous_nodes(memory),
        water(memory),
        bolts(memory) {}
  Model(const Model&) = delete;  // the parts of a world refer to it

  const ContactLaw& law_between(std::size_t a, std::size_t b) const {
    return materials.laws().between(blocks.material[a], blocks.material[b]);
  }
  template <class Pair>
  const ContactLaw& law_of(const Pair& pair) const {
    return law_between(std::size_t(pair.a), std::size_t(pair.b));
  }
  /// Do two blocks meet without springs, in a manifold? They do unless one deforms or is held, or the law
  /// bonds.
  template <class Pair>
  bool has_manifold(const Pair& pair) const {
    return meets_without_springs(pair, false);
  }
  /// Or in single points?
  template <class Pair>
  bool has_points(const Pair& pair) const {
    return meets_without_springs(pair, true);
  }
  /// May any two blocks meet in single points without springs?
  bool may_have_points() const {
    return blocks.has_deformable() || blocks.any_held() || materials.laws().any(bonds_without_spring);
  }
  const Elasticity& elasticity_of(std::size_t block) const {
    return materials.elasticity(blocks.material[block]);
  }

  /// The load of a block by water at its present position.
  WaterLoad<D> water_load_on(std::size_t block) const {
    return water.load_on(blocks, block, water.unit_weight(settings.gravity));
  }

  /// H of potential laws: one length for all blocks (Zheng et al. 2020, section 3.2).
  double potential_length() const;
  /// Keeps the length constant from the first force evaluation on, whatever happens to the blocks.
  void fix_potential_length() {
    if (materials.laws().knows_potential()) fixed_length = potential_length();
  }

  bool is_consistent() const {
    return settings.is_consistent() && materials.is_consistent() && blocks.is_consistent(materials.count()) &&
           actions.is_consistent(blocks) && viscous_nodes.is_consistent(blocks.meshes()) &&
           water.is_consistent() && bolts.is_consistent(blocks) && is_nonnegative(fixed_length);
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(settings, materials, blocks, actions, viscous_nodes, fixed_length, water, bolts);
  }

  WorldSettings<D> settings;
  Materials materials;
  Blocks<D> blocks;
  Actions<D> actions;  // loads and motions in time
  ViscousNodes<D> viscous_nodes;
  Water<D> water;
  Bolts<D> bolts;
  double fixed_length = 0;  // H, from the first force evaluation on; 0 before

 private:
  static bool bonds_without_spring(const ContactLaw& law) { return law.has_no_spring() && law.bonds(); }
  template <class Pair>
  bool meets_without_springs(const Pair& pair, bool in_points) const {
    const ContactLaw& law = law_of(pair);
    const auto needs_points = [&](std::size_t i) {
      return blocks.is_deformable(i) || blocks.held[blocks.mover_of(i)] != 0;
    };
    return law.has_no_spring() && in_points == (law.bonds() || needs_points(std::size_t(pair.a)) ||
                                                needs_points(std::size_t(pair.b)));
  }
};

extern template struct Model<2>;
extern template struct Model<3>;

}  // namespace halfspace
