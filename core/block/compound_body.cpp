#include "block/compound_body.h"

#include <algorithm>

namespace halfspace {

/// Arms are those from the centroid, so that the parallel axis theorem loses no digits far from the origin.
template <int D>
CompoundBody<D> compound_body(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                              double density) {
  CompoundBody<D> body;
  for (const Shape<D>* shape : shapes) body.mass += mass_of(*shape, density);
  const Vector<D> origin = poses.front().position;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    body.centroid += mass_of(*shapes[i], density) / body.mass * (poses[i].position - origin);
  body.centroid += origin;
  InertiaTensor<D> tensor = InertiaTensor<D>::Zero();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Vector<D> arm = poses[i].position - body.centroid;
    tensor += Inertia<D>::of(*shapes[i], density).tensor(poses[i].rotation) +
              inertia_of_point(mass_of(*shapes[i], density), arm);
    const Outline<D>& outline = shapes[i]->outline();
    for (int k = 0; k < outline.vertex_count(); ++k)
      body.radius = std::max(body.radius, (arm + poses[i].rotation * outline.vertex(k)).norm());
  }
  body.inertia = Inertia<D>::of(tensor);
  return body;
}

template CompoundBody<2> compound_body(std::span<const Shape<2>* const>, std::span<const Pose<2>>, double);
template CompoundBody<3> compound_body(std::span<const Shape<3>* const>, std::span<const Pose<3>>, double);

}  // namespace halfspace
