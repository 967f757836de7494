#pragma once

#include "geometry/pose.h"
#include "halfspace/view.h"
#include "require.h"

namespace halfspace::capi {

/// A pose as core takes it.
inline GivenPose given(const hs_pose& pose) { return {pose.position, pose.rotation}; }

/// Refuses an invalid pose. The text names the faulty component.
template <int D>
[[noreturn]] void refuse_pose(const GivenPose& pose, const ArgumentName& argument) {
  const NameText name(argument);
  for (int i = 0; i < D; ++i) {
    const double p = pose.position[i];
    if (!is_within_limits(p)) {
      refuse(HS_ERROR_ARGUMENT, "%s->position[%d] is %g; it must be finite and at most 1e75", name.characters,
             i, p);
    }
  }
  const double* q = pose.quaternion;
  refuse(HS_ERROR_ARGUMENT, "%s->rotation is (%.9g, %.9g, %.9g, %.9g); it must be a unit quaternion%s",
         name.characters, q[0], q[1], q[2], q[3], D == 2 ? " that turns about z" : "");
}

template <int D>
void require_pose(const GivenPose& pose, const ArgumentName& name) {
  if (!is_tolerable<D>(pose)) refuse_pose<D>(pose, name);
}

template <int D>
Pose<D> read_pose(const hs_pose* pose, const ArgumentName& name) {
  require_pointer(pose, name);
  require_pose<D>(given(*pose), name);
  return pose_of<D>(given(*pose));
}

/// Reads the pose of a block of a world, whose position is limited by its radius.
template <int D>
Pose<D> read_place(const hs_pose* pose, double radius, const ArgumentName& name) {
  const Pose<D> place = read_pose<D>(pose, name);
  const double farthest = farthest_place * radius;
  for (int i = 0; i < D; ++i) {
    if (std::abs(place.position[i]) <= farthest) continue;
    refuse(HS_ERROR_ARGUMENT,
           "%s->position[%d] is %g; for a block of radius %g it must be at most %g, to limit rounding "
           "relative to its size",
           NameText(name).characters, i, place.position[i], radius, farthest);
  }
  return place;
}

template <int D>
Vector<D> read_finite_vector(const double* values, const char* name) {
  require_pointer(values, name);
  Vector<D> vector;
  for (int i = 0; i < D; ++i) vector[i] = require_component(values[i], name, i);
  return vector;
}

/// The third component, 0 in 2D.
template <class Vector>
double z_of(const Eigen::MatrixBase<Vector>& v) {
  if constexpr (Vector::SizeAtCompileTime == 2) {
    return 0;
  } else {
    return v.z();
  }
}

template <class Vector>
void write_vector(const Eigen::MatrixBase<Vector>& v, double out[3]) {
  out[0] = v.x();
  out[1] = v.y();
  out[2] = z_of(v);
}

template <int D>
void write_pose(const Vector<D>& position, const Rotation<D>& rotation, hs_pose& pose) {
  write_vector(position, pose.position);
  rotation.write_quaternion(pose.rotation);
}

}  // namespace halfspace::capi
