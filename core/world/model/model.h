#pragma once

#include "block/blocks.h"
#include "world/loads/bolts.h"
#include "world/loads/water.h"
#include "world/model/materials.h"
#include "world/model/settings.h"

namespace halfspace {

/// Settings, materials and blocks of a world, water and bolts. The world's parts read them and move the
/// blocks.
template <int D>
struct Model {
  Model(const WorldSettings<D>& given, Memory* memory)
      : settings(given), materials(memory), blocks(memory), water(memory), bolts(memory) {}
  Model(const Model&) = delete;  // the parts of a world refer to it

  const ContactLaw& law_between(std::size_t a, std::size_t b) const {
    return materials.laws().between(blocks.material[a], blocks.material[b]);
  }
  template <class Pair>
  const ContactLaw& law_of(const Pair& pair) const {
    return law_between(std::size_t(pair.a), std::size_t(pair.b));
  }
  /// Do contacts by laws without springs have manifolds? They do when no block deforms, and no such law
  /// bonds.
  bool has_manifolds() const {
    return !blocks.has_deformable() &&
           !materials.laws().any([](const ContactLaw& law) { return law.has_no_spring() && law.bonds(); });
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
           is_nonnegative(fixed_length) && water.is_consistent() && bolts.is_consistent(blocks);
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(settings, materials, blocks, fixed_length, water, bolts);
  }

  WorldSettings<D> settings;
  Materials materials;
  Blocks<D> blocks;
  Water<D> water;
  Bolts<D> bolts;
  double fixed_length = 0;  // H, from the first force evaluation on; 0 before
};

extern template struct Model<2>;
extern template struct Model<3>;

}  // namespace halfspace
