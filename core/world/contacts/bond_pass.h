#pragma once

#include <cmath>

#include "block/bond/bonds.h"
#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Strain energy and losses of bonds.
struct BondEnergy {
  double strain = 0;
  double fracture_loss = 0;
  double friction_loss = 0;
};

/// Computes the forces of bonds, and their failure. A bond that has failed at all of its points acts as a
/// frictional joint until it opens or slides far; then contact replaces it. The contact of an open joint
/// begins without force; that of a joint that has slid far takes over its shear force.
template <int D>
class BondPass {
 public:
  explicit BondPass(Model<D>& model) : model_(model), blocks_(model.blocks), bonds_(model.blocks.bonds()) {}

  /// Adds the forces of bonds to those of contacts. Returns true when the neighbour list needs a rebuild: a
  /// joint or a ring of bonds no longer connects a pair.
  bool load(std::int64_t step, double time, BondEnergy& energy);
  /// Adds the shear forces of separated joints to their contacts. Precondition: the neighbour list contains
  /// the pairs.
  void hand_over(ContactList<D>& contacts);

 private:
  /// The current poses of a bond's two blocks.
  struct Placement {
    Vector<D> normal;
    Vector<D> to_b;
    Tensor<D> frame_a;
    Tensor<D> frame_b;
    Tensor<D> turn_a;
  };
  /// The force of a bond on its second block, summed over its points.
  struct Load {
    Vector<D> force = Vector<D>::Zero();
    Tensor<D> on_a = Tensor<D>::Zero();  // force times arm^T
    Tensor<D> on_b = Tensor<D>::Zero();
  };
  /// The state of a bond's points. A bond stays a joint while a point is closed and the minimum slip is
  /// small.
  struct Hold {
    bool is_closed = false;  // at any point
    double min_slip = HUGE_VAL;
    bool has_broken = false;  // at any point, in this step
  };

  Vector<D> normal_of(const Bond<D>& bond) const;
  Placement placement_of(const Bond<D>& bond) const;
  void load_point(std::int64_t bond, std::int64_t number, const Placement& at, BondPoint<D>& point,
                  Load& load, Hold& hold, BondEnergy& energy);
  void load_blocks(const Bond<D>& bond, const Load& load);
  void note_failure(std::int64_t bond, std::int64_t number, const BondPoint<D>& before,
                    const BondPoint<D>& after, const Vector<D>& position, const Vector<D>& normal,
                    double energy);

  Model<D>& model_;
  Blocks<D>& blocks_;
  Bonds<D>& bonds_;
  std::int64_t step_ = 0;
  double time_ = 0;
};

extern template class BondPass<2>;
extern template class BondPass<3>;

}  // namespace halfspace
