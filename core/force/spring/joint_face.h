#pragma once

#include "narrow_phase/contact.h"

namespace halfspace {

/// Springs spread evenly over the region of a contact, for unit stiffness per area: what holds two faces
/// together that were one. They pull as well as push.
template <int D>
struct JointFace {
  double base = 0;  // length or area
  double force = 0;
  Angular<D> couple = Angular<D>::Zero();  // on b, about the centre
  double depth_squared = 0;                // integral: twice the energy
  double twist_radius = 0;
  Tensor<D> spread = Tensor<D>::Zero();  // mean of the way from the centre times itself^T
  Vector<D> center = Vector<D>::Zero();
};

/// Does the contact have such a region? Two edges in the plane, two faces in space.
inline bool is_joint_face(const Contact<2>& contact) { return contact.point_count == 2; }
inline bool is_joint_face(const Contact<3>& contact) { return contact.type == ContactType::face_face; }

JointFace<2> joint_face(const Contact<2>& contact);
JointFace<3> joint_face(const Contact<3>& contact);

}  // namespace halfspace
