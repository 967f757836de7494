#pragma once

#include <cmath>

#include "block/bond/bonds.h"
#include "world/contacts/contact_list.h"
#include "world/ledger.h"
#include "world/model/model.h"

namespace halfspace {

/// The energy that bonds hold and lose.
struct BondEnergy {
  double strain = 0;
  double fracture_loss = 0;
  double friction_loss = 0;
};

/// Loads blocks with the forces of their bonds, and lets bonds fail. A bond that has failed at all of its
/// points is a joint that rubs, until it is open or has slid far: then contact takes over. An open joint has
/// no force, and neither has the contact that begins; one that has slid far hands its shear force over.
template <int D>
class BondPass {
 public:
  explicit BondPass(Model<D>& model) : model_(model), blocks_(model.blocks), bonds_(model.blocks.bonds()) {}

  /// Loads come on top of those of contacts. Returns true when a pair has come apart that contact must know
  /// of.
  bool load(std::int64_t step, double time, BondEnergy& energy);
  /// Gives contacts the shear forces of joints that have come apart. The neighbour list knows their pairs.
  void hand_over(ContactList<D>& contacts);

 private:
  /// The places of a bond's two blocks now.
  struct Placement {
    Vector<D> normal;
    Vector<D> to_b;
    Tensor<D> frame_a;
    Tensor<D> frame_b;
    Tensor<D> turn_a;
  };
  /// The force of a bond on its second block, gathered over its points.
  struct Load {
    Vector<D> force = Vector<D>::Zero();
    Tensor<D> on_a = Tensor<D>::Zero();  // force times arm^T
    Tensor<D> on_b = Tensor<D>::Zero();
  };
  /// The state of a bond's points, of which two things keep it a joint.
  struct Hold {
    bool is_closed = false;  // somewhere
    double least_slip = HUGE_VAL;
    bool has_broken = false;  // somewhere, just now
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
