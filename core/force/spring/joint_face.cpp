#include "force/spring/joint_face.h"

namespace halfspace {

JointFace<2> joint_face(const Contact<2>& contact) {
  const double mean = 0.5 * (contact.gaps[0] + contact.gaps[1]);
  const double difference = contact.gaps[1] - contact.gaps[0];
  const Vector<2> along = contact.points[1] - contact.points[0];
  JointFace<2> face;
  face.base = contact.length;
  face.force = -face.base * mean;
  face.spread = along * along.transpose() / 12;
  face.couple = -face.base * difference / 12 * moment(along, contact.normal);
  face.depth_squared = face.base * (mean * mean + difference * difference / 12);
  face.center = 0.5 * (contact.points[0] + contact.points[1]);
  return face;
}

/// The gap is linear: exact by triangles from the centroid to the sides.
JointFace<3> joint_face(const Contact<3>& contact) {
  const double at_center = contact.center_gap;
  Tensor<3> spread = Tensor<3>::Zero();  // integral of r r^T about the centroid
  Vector<3> tilted = Vector<3>::Zero();  // integral of the gap's linear part times r
  double squared = 0;                    // integral of its square
  for (int i = 0; i < contact.point_count; ++i) {
    const int j = i + 1 == contact.point_count ? 0 : i + 1;
    const Vector<3> p = contact.points[i] - contact.center, q = contact.points[j] - contact.center;
    const double gap_p = contact.gaps[i] - at_center, gap_q = contact.gaps[j] - at_center;
    const double area = 0.5 * contact.normal.dot(cross_product(p, q));
    tilted += area / 12 * ((2 * gap_p + gap_q) * p + (gap_p + 2 * gap_q) * q);
    squared += area / 6 * (gap_p * gap_p + gap_p * gap_q + gap_q * gap_q);
    spread += area / 12 * (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose());
  }
  JointFace<3> face;
  face.base = contact.area;
  face.force = -face.base * at_center;
  face.couple = -moment(tilted, contact.normal);
  face.depth_squared = face.base * at_center * at_center + squared;
  face.spread = spread / face.base;
  face.center = contact.center;
  return face;
}

}  // namespace halfspace
