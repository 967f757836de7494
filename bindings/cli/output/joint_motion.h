#pragma once

#include <vector>

#include "model/model.h"

namespace halfspace::cli {

/// The relative motion of two blocks at their joint, and the force between them.
struct JointState {
  double opening = 0;  ///< m, along the normal of block a; below 0 if the blocks overlap
  double slip = 0;     ///< m, since the start; 2D: above 0 if block b moves to the left, seen from block a
  double normal_force = 0;  ///< N, compression > 0
  double shear_force = 0;   ///< N; 2D: above 0 if it resists a slip above 0
};

/// A joint between two blocks: a plane that block a carries along, and the point of block b on it.
class JointMotion {
 public:
  /// The model is at its start.
  JointMotion(const Model& start, const LayoutJoint& joint);
  JointState state(const Model& model, const std::vector<hs_contact>& contacts,
                   const std::vector<hs_bond>& bonds) const;

 private:
  /// 1 if a contact or bond is from block a to block b, -1 if it is from b to a, 0 if it is between others.
  template <class Connection>
  int direction_of(const Connection& connection) const;

  LayoutJoint joint_;
  int dimension_;
  CarriedPoint center_;              ///< of block a
  std::vector<CarriedPoint> along_;  ///< points of block a: with the center they span the joint's plane
  CarriedPoint of_b_;
};

}  // namespace halfspace::cli
