#pragma once

#include "block/blocks.h"
#include "world/loads/water_table.h"

namespace halfspace {

/// The resultant of a pressure on the faces of a block, about its centroid, and its potential energy.
template <int D>
struct WaterLoad {
  Vector<D> force = Vector<D>::Zero();
  Tensor<D> virial = Tensor<D>::Zero();  // force times arm^T
  double energy = 0;
};

/// Water below a table. It presses on the faces of blocks, joints included, by its depth times its weight.
/// The pressure depends on the place only, so it has a potential: its integral over the volume of the block.
template <int D>
class Water {
 public:
  explicit Water(Memory* memory) : table_(memory) {}

  bool empty() const { return table_.empty(); }
  void set(WaterTable<D>&& table, double density) {
    table_ = std::move(table);
    density_ = density;
  }
  /// The increase of the pressure per depth, Pa/m. Water weighs nothing where gravity points up.
  double unit_weight(const Vector<D>& gravity) const { return density_ * std::max(-gravity[D - 1], 0.0); }
  /// The load of a block at its present position. Of a mesh, only faces at its surface bear water.
  WaterLoad<D> load_on(const Blocks<D>& blocks, std::size_t slot, double unit_weight) const;
  /// A bound of the stiffness of the load on a block.
  double stiffness_on(const Blocks<D>& blocks, std::size_t slot, double unit_weight) const;

  bool is_consistent() const { return table_.is_consistent() && is_nonnegative(density_); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(table_, density_);
  }

 private:
  WaterTable<D> table_;
  double density_ = 0;  // times the factor of the pressure
};

extern template class Water<2>;
extern template class Water<3>;

}  // namespace halfspace
