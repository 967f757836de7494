#pragma once

#include "narrow_phase/contact.h"

namespace halfspace {

/// Springs distributed over the region of a bonded contact of two faces, for unit stiffness per area. They
/// act in tension and compression.
template <int D>
struct JointFace {
  double base = 0;  // length or area
  double force = 0;
  Angular<D> couple = Angular<D>::Zero();  // on b, about the centre
  double depth_squared = 0;                // integral: twice the energy
  Tensor<D> spread = Tensor<D>::Zero();    // mean of r r^T about the centre
  Vector<D> center = Vector<D>::Zero();
};

/// Does the contact have such a region? Two edges in 2D, two faces in 3D.
inline bool is_joint_face(const Contact<2>& contact) { return contact.point_count == 2; }
inline bool is_joint_face(const Contact<3>& contact) { return contact.type == ContactType::face_face; }

JointFace<2> joint_face(const Contact<2>& contact);
JointFace<3> joint_face(const Contact<3>& contact);

}  // namespace halfspace
