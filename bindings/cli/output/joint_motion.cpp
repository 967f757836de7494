#include "output/joint_motion.h"

#include <cmath>

#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// The normal in the plane, turned counter-clockwise.
Point left_of(const Point& normal) { return {-normal[1], normal[0], 0}; }

/// Two directions that form a right-handed frame with the normal; in 2D the first one is left of it.
std::array<Point, 2> directions_along(const Point& normal, int dimension) {
  if (dimension == 2) return {left_of(normal), {}};
  const Point axis = std::abs(normal[2]) < 0.5 ? Point{0, 0, 1} : Point{1, 0, 0};
  const Point first = unit(cross(axis, normal));
  return {first, cross(normal, first)};
}

}  // namespace

JointMotion::JointMotion(const Model& start, const LayoutJoint& joint)
    : joint_(joint),
      dimension_(start.layout().dimension),
      center_(start.carry(joint.block_a, joint.center)),
      of_b_(start.carry(joint.block_b, plus(joint.center, times(joint.gap, joint.normal)))) {
  const std::array<Point, 2> directions = directions_along(joint.normal, dimension_);
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(dimension_); ++i)
    along_.push_back(start.carry(joint.block_a, plus(joint.center, directions[i])));
}

template <class Connection>
int JointMotion::direction_of(const Connection& connection) const {
  if (connection.block_a == joint_.block_a && connection.block_b == joint_.block_b) return 1;
  return connection.block_a == joint_.block_b && connection.block_b == joint_.block_a ? -1 : 0;
}

JointState JointMotion::state(const Model& model, const std::vector<hs_contact>& contacts,
                              const std::vector<hs_bond>& bonds) const {
  const Point center = model.position_of(center_);
  const Point apart = minus(model.position_of(of_b_), center);
  const Point first = unit(minus(model.position_of(along_[0]), center));
  const Point normal = dimension_ == 2 ? Point{first[1], -first[0], 0}
                                       : unit(cross(first, minus(model.position_of(along_[1]), center)));
  JointState state;
  state.opening = dot(apart, normal);
  state.slip = dimension_ == 2 ? dot(apart, first) : length(minus(apart, times(state.opening, normal)));
  Point shear{};
  for (const hs_contact& contact : contacts) {
    const int direction = direction_of(contact);
    if (direction == 0) continue;
    state.normal_force += contact.normal_force;
    shear = plus(shear, times(direction, point_of(contact.shear_force)));
  }
  for (const hs_bond& bond : bonds) {
    const int direction = direction_of(bond);
    if (direction == 0) continue;
    state.normal_force -= bond.normal_force;
    shear = plus(shear, times(direction, point_of(bond.shear_force)));
  }
  state.shear_force = dimension_ == 2 ? -dot(shear, first) : length(shear);
  return state;
}

}  // namespace halfspace::cli
