#pragma once

#include <algorithm>
#include <cstdint>

#include "block/elasticity.h"
#include "block/mesh/meshes.h"
#include "force/law.h"
#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

/// In this range, division by the factor and multiplication keep strengths finite.
inline bool is_strength_factor(double factor) { return factor >= 1e-75 && factor <= 1e75; }

/// The materials of a world: density, elasticity, and the contact law of each pair.
class Materials {
 public:
  explicit Materials(Memory* memory) : density_(memory), elasticity_(memory), laws_(memory) {}

  std::int32_t count() const { return std::int32_t(density_.size()); }
  std::int32_t add(double density) {
    make_room_for_one(density_);
    make_room_for_one(elasticity_);
    laws_.add_material();
    density_.push_back(density);
    elasticity_.push_back({});
    return count() - 1;
  }
  double density(std::int32_t material) const { return density_[std::size_t(material)]; }
  void set_elasticity(std::int32_t material, const Elasticity& elasticity) {
    elasticity_[std::size_t(material)] = elasticity;
  }
  const Elasticity& elasticity(std::int32_t material) const { return elasticity_[std::size_t(material)]; }
  bool any_elastic() const {
    return std::any_of(elasticity_.begin(), elasticity_.end(),
                       [](const Elasticity& elasticity) { return elasticity.is_given(); });
  }
  BulkMaterials bulk() const { return {density_, elasticity_}; }
  LawTable& laws() { return laws_; }
  const LawTable& laws() const { return laws_; }

  /// Validates the state read from a snapshot.
  bool is_consistent() const {
    return laws_.is_consistent() && laws_.material_count() == count() && all(density_, is_positive) &&
           elasticity_.size() == density_.size() &&
           all(elasticity_, [](const Elasticity& elasticity) { return elasticity.is_consistent(); });
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(density_, elasticity_, laws_);
  }

 private:
  Array<double> density_;
  Array<Elasticity> elasticity_;
  LawTable laws_;
};

}  // namespace halfspace
