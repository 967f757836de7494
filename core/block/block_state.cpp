#include "block/block_state.h"

#include "block/blocks.h"
#include "geometry/polyhedron/topology.h"

namespace halfspace {

template <>
bool OutlineCopy<2>::is_complete() const {
  return vertices >= 3 && topology.empty() &&
         components.size() == 5 * std::size_t(Outline<2>::padded(vertices));
}

template <>
bool OutlineCopy<3>::is_complete() const {
  return vertices >= 4 && edges >= 6 && faces >= 4 &&
         std::int64_t(topology.size()) == topology_length(vertices, edges, faces) &&
         components.size() ==
             3 * std::size_t(Outline<3>::padded(vertices)) + 4 * std::size_t(Outline<3>::padded(faces));
}

template <int D>
BlockState<D> Blocks<D>::state_of(std::size_t s) const {
  BlockState<D> state{kind[s],     material[s], generation[s],    held[s],           position[s],
                      velocity[s], force[s],    applied_force[s], rotation[s],       D == 2 ? angle[s] : 0,
                      spin[s],     momentum[s], torque[s],        applied_torque[s], mass[s],
                      inertia[s],  radius[s],   largest_face[s],  thickness[s],      {}};
  if (is_affine(s)) {
    state.deformation = deformation(s);
    state.deformation.slot = -1;
  }
  return state;
}

template <int D>
std::int32_t Blocks<D>::add(const BlockState<D>& state, const OutlineCopy<D>& own) {
  const std::int32_t slot = add(state, outlines_.take_in(own));
  renew_outline(slot);
  return slot;
}

template <int D>
void Blocks<D>::renew_outline(std::int32_t slot) {
  const std::size_t s = std::size_t(slot);
  is_affine(s) ? outlines_.deform(slot, deformation(s).gradient) : outlines_.turn(slot, rotation[s]);
}

template <int D>
std::int32_t Blocks<D>::add(const BlockState<D>& state, const Blocks& other, std::int32_t slot) {
  return add(state, outlines_.take_over(other.outlines_, slot));
}

template <int D>
std::int32_t Blocks<D>::add(const BlockState<D>& state, const typename Outlines<D>::Taken& outline) {
  const std::int32_t slot = occupy(outline, state.kind, state.material);
  const std::size_t s = std::size_t(slot);
  generation[s] = state.generation;
  held[s] = state.held;
  held_count_ += state.held != 0;
  position[s] = state.position;
  velocity[s] = state.velocity;
  force[s] = state.force;
  applied_force[s] = state.applied_force;
  rotation[s] = state.rotation;
  if constexpr (D == 2) angle[s] = state.angle;
  spin[s] = state.spin;
  momentum[s] = state.momentum;
  torque[s] = state.torque;
  applied_torque[s] = state.applied_torque;
  mass[s] = state.mass;
  inertia[s] = state.inertia;
  radius[s] = state.radius;
  largest_face[s] = state.largest_face;
  thickness[s] = state.thickness;
  if (state.kind == BlockKind::affine) {
    Deformation<D> deformation = state.deformation;
    deformation.slot = slot;
    deformations_.add(deformation);
  }
  return slot;
}

#define HALFSPACE_MEMBERS(D)                                                                  \
  template BlockState<D> Blocks<D>::state_of(std::size_t) const;                              \
  template void Blocks<D>::renew_outline(std::int32_t);                                       \
  template std::int32_t Blocks<D>::add(const BlockState<D>&, const OutlineCopy<D>&);          \
  template std::int32_t Blocks<D>::add(const BlockState<D>&, const Blocks<D>&, std::int32_t); \
  template std::int32_t Blocks<D>::add(const BlockState<D>&, const typename Outlines<D>::Taken&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
