#include "world/hard_contact/point_contact_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// The share of a face that belongs to one of its corners; 0 for a corner that is none of it.
double share_of_corner(const Outline<2>& o, int face, int corner) {
  return corner == face || corner == o.next(face) ? 0.5 : 0;
}
double share_of_corner(const Outline<3>& o, int face, int corner) {
  const std::int32_t* first = o.topology->face_vertex + o.topology->first_of_face[face];
  const std::int32_t* last = o.topology->face_vertex + o.topology->first_of_face[face + 1];
  return std::find(first, last, corner) != last ? 1 / double(last - first) : 0;
}

}  // namespace

template <int D>
PointContactSearch<D>::Pose::Pose(const Vector<D>& at, const Tensor<D>& turned_by)
    : position(at), gradient(turned_by), inverse(turned_by.inverse()) {}

template <int D>
typename PointContactSearch<D>::Pose PointContactSearch<D>::pose_now(std::size_t slot) const {
  return {blocks_.position[slot], blocks_.gradient(slot)};
}

template <int D>
typename PointContactSearch<D>::Pose PointContactSearch<D>::predicted_pose(std::size_t slot) const {
  if (!blocks_.moves(slot)) return pose_now(slot);
  const Vector<D> position = blocks_.position[slot] + integrator_.predicted_displacement(slot);
  if (blocks_.is_deformable(slot))
    return {position, blocks_.gradient(slot) + integrator_.predicted_stretch(slot)};
  return {position, integrator_.predicted_rotation(slot).tensor()};
}

template <int D>
Vector<D> PointContactSearch<D>::node_now(std::size_t slot, std::int32_t node) const {
  const Meshes<D>& meshes = blocks_.meshes();
  return meshes.body(meshes.surface_of_block(slot).body).origin + meshes.place[std::size_t(node)];
}

template <int D>
Vector<D> PointContactSearch<D>::corner_now(std::size_t slot, int corner) const {
  if (blocks_.is_of_mesh(slot))
    return node_now(slot, blocks_.meshes().surface_of_block(slot).node[std::size_t(corner)]);
  return blocks_.position[slot] +
         blocks_.gradient(slot) * blocks_.own_outline(std::int32_t(slot)).vertex(corner);
}

template <int D>
Vector<D> PointContactSearch<D>::predicted_corner(std::size_t slot, int corner) const {
  if (blocks_.is_of_mesh(slot)) {
    const std::int32_t node = blocks_.meshes().surface_of_block(slot).node[std::size_t(corner)];
    return corner_now(slot, corner) + integrator_.predicted_displacement_of_node(std::size_t(node));
  }
  const Pose pose = predicted_pose(slot);
  return pose.position + pose.gradient * blocks_.own_outline(std::int32_t(slot)).vertex(corner);
}

/// A node of a mesh at its surface is the corner of one of the cells that share it.
template <int D>
void PointContactSearch<D>::rebuild_surface() {
  const Meshes<D>& meshes = blocks_.meshes();
  owner_.assign(meshes.node_count(), -1);
  for (const SurfaceCell<D>& cell : meshes.surface()) {
    for (int i = 0; i <= D; ++i) {
      const bool is_outside = (cell.outer_faces & ~(1 << i)) != 0;
      std::int32_t& owner = owner_[std::size_t(cell.node[std::size_t(i)])];
      if (is_outside && owner < 0) owner = cell.block;
    }
  }
  rebuild_surface_edges();
}

/// A weight falls from 1 to 0 over the height of its node: the area of the face opposite is D volume /
/// height.
template <int D>
void PointContactSearch<D>::compute_node_normals() {
  const Meshes<D>& meshes = blocks_.meshes();
  outwards_.assign(meshes.node_count(), Vector<D>::Zero());
  for (const SurfaceCell<D>& cell : meshes.surface()) {
    const Deformation<D>& deformation = blocks_.deformation(std::size_t(cell.block));
    const double volume = deformation.volume * deformation.gradient.determinant();
    const Tensor<D> back = deformation.gradient.inverse().transpose();
    for (int i = 0; i <= D; ++i) {
      if (!(cell.outer_faces >> i & 1)) continue;
      const Vector<D> of_corner = -volume * (back * cell.gradients.col(i));
      for (int k = 0; k <= D; ++k) {
        if (k != i) outwards_[std::size_t(cell.node[std::size_t(k)])] += of_corner;
      }
    }
  }
}

template <int D>
Vector<D> PointContactSearch<D>::outwards(std::size_t slot, int corner) const {
  if (!blocks_.is_of_mesh(slot)) return corner_now(slot, corner) - blocks_.position[slot];
  return outwards_[std::size_t(blocks_.meshes().surface_of_block(slot).node[std::size_t(corner)])];
}

template <int D>
bool PointContactSearch<D>::owns_vertex(std::size_t slot, int corner) const {
  if (!blocks_.is_of_mesh(slot)) return true;
  const std::int32_t node = blocks_.meshes().surface_of_block(slot).node[std::size_t(corner)];
  return owner_[std::size_t(node)] == std::int32_t(slot);
}

/// A face that does not look at a counts where its corner comes well inside of all others: else it passes an
/// end of the face.
template <int D>
bool PointContactSearch<D>::is_well_inside(const Target& b, const Vector<D>& end, int but_for) const {
  const Outline<D> own = blocks_.own_outline(std::int32_t(b.slot));
  for (int face = 0; face < own.face_count(); ++face) {
    const double depth = (own.offset[face] - own.normal(face).dot(end)) /
                         (b.predicted.inverse.transpose() * own.normal(face)).norm();
    if (face != but_for && depth < touch_reach * blocks_.radius[b.slot]) return false;
  }
  return true;
}

/// Through which face of b does a corner of a come in, if any? It is inside where all half-spaces include it,
/// and it came in through the one that included it last. Of those that have included it from the start only
/// one counts that looks at a: flush with b's front, a corner lies in the plane of b's side, too. Of several
/// that it is at, it slides along the one that it leaves least deep behind: on a floor, from one block onto
/// the next. Along a face it may slide into b from the side.
template <int D>
typename PointContactSearch<D>::Entrance PointContactSearch<D>::entrance(const Target& b, std::size_t a,
                                                                         int corner) const {
  const Outline<D> own = blocks_.own_outline(std::int32_t(b.slot));
  const double radius = blocks_.radius[b.slot], reach = this->reach(b.slot);
  const Vector<D> start = b.now.inverse * (corner_now(a, corner) - b.now.position);
  const Vector<D> end = b.predicted.inverse * (predicted_corner(a, corner) - b.predicted.position);
  const Vector<D> out_of_a = outwards(a, corner).normalized();
  const double tiny = std::max(touch_reach * radius, reach);
  Entrance last, at_start;
  bool is_beside = false;
  for (int face = 0; face < own.face_count(); ++face) {
    const Vector<D> normal = b.now.inverse.transpose() * own.normal(face);
    const double before = (own.normal(face).dot(start) - own.offset[face]) / normal.norm();
    const double after = (own.normal(face).dot(end) - own.offset[face]) /
                         (b.predicted.inverse.transpose() * own.normal(face)).norm();
    if (after > margin_) return {};
    if (!b.is_outer(own, face)) {
      is_beside = is_beside || before > reach;
      continue;
    }
    Entrance through{face, 0, before, after, normal.dot(out_of_a) < -facing_cosine * normal.norm()};
    if (through.looks_at_a && std::abs(before) <= tiny && after >= at_start.after) at_start = through;
    if (before <= reach) {
      if (!through.looks_at_a) continue;
      through.time = before / radius - 1;
    } else {
      // Times after the end stand for those that do not come in, by how far they stay away.
      through.time = after < 0 ? before / (before - after) : 1 + after;
    }
    if (through.time > last.time) last = through;
  }
  if (at_start.face >= 0) last = at_start;
  if (!last.looks_at_a && (last.time > 1 || !is_well_inside(b, end, last.face))) return {};
  // The plane of a face goes on beyond the face: a corner beside it that is behind its plane is before the
  // neighbouring face.
  if (is_beside && last.before < -tiny) return {};
  return last;
}

template <int D>
void PointContactSearch<D>::find_vertex_face(std::int32_t a, std::int32_t b,
                                             Array<ContactConstraint<D>>& found) const {
  const std::size_t slot_a = std::size_t(a), slot_b = std::size_t(b);
  const bool is_of_mesh = blocks_.is_of_mesh(slot_b);
  const Target target{slot_b, pose_now(slot_b), predicted_pose(slot_b),
                      is_of_mesh ? blocks_.meshes().surface_of_block(slot_b).outer_faces : -1};
  for (int corner = 0; corner < blocks_.own_outline(a).vertex_count(); ++corner) {
    if (!owns_vertex(slot_a, corner)) continue;
    const Entrance through = entrance(target, slot_a, corner);
    if (through.face < 0) continue;
    ContactConstraint<D> at;
    at.a = a;
    at.b = b;
    at.feature_a = corner;
    at.feature_b = through.face;
    at.impact_fraction = std::clamp(through.time, 0.0, 1.0);
    found.push_back(at);
  }
}

template <int D>
MaterialPoint<D> PointContactSearch<D>::corner_of(std::int32_t block, int corner) const {
  const std::size_t slot = std::size_t(block);
  MaterialPoint<D> point;
  point.block = block;
  if (blocks_.is_of_mesh(slot)) {
    point.node.fill(blocks_.meshes().surface_of_block(slot).node[std::size_t(corner)]);
    point.weight = Vector<D>::Unit(0);
  } else {
    const Vector<D> vertex = blocks_.own_outline(block).vertex(corner);
    point.arm = blocks_.is_affine(slot) ? vertex : Vector<D>(blocks_.gradient(slot) * vertex);
  }
  return point;
}

/// The corner, and the point of the face below it.
template <int D>
void PointContactSearch<D>::place_corner(ContactConstraint<D>& at) const {
  const std::size_t b = std::size_t(at.b);
  const Pose pose = pose_now(b);
  const Outline<D> own = blocks_.own_outline(at.b);
  const Vector<D> outwards = pose.inverse.transpose() * own.normal(at.feature_b);
  const Vector<D> in_b = pose.inverse * (corner_now(std::size_t(at.a), at.feature_a) - pose.position);
  at.normal = outwards.normalized();
  at.gap = (own.normal(at.feature_b).dot(in_b) - own.offset[at.feature_b]) / outwards.norm();
  at.of_a = corner_of(at.a, at.feature_a);
  at.of_b.block = at.b;
  const Vector<D> below = in_b - at.gap * (pose.inverse * at.normal);
  if (!blocks_.is_of_mesh(b)) {
    at.of_b.arm = blocks_.is_affine(b) ? below : Vector<D>(pose.gradient * below);
    return;
  }
  const SurfaceCell<D>& cell = blocks_.meshes().surface_of_block(b);
  const int left_out = node_opposite(own, at.feature_b);
  for (int i = 0, k = 0; i <= D; ++i) {
    if (i == left_out) continue;
    at.of_b.node[std::size_t(k)] = cell.node[std::size_t(i)];
    at.of_b.weight[k++] = 1.0 / (D + 1) + cell.gradients.col(i).dot(below);
  }
  at.of_b.weight.array() += (1 - at.of_b.weight.sum()) / D;  // that of the node left out: rounding
}

template <int D>
void PointContactSearch<D>::place(ContactConstraint<D>& at) const {
  if (at.meeting == Meeting::edges) {
    place_edges(at);
  } else {
    place_corner(at);
  }
  const Tensor<D> mobility = inverse_mass_at(at.of_a, blocks_) + inverse_mass_at(at.of_b, blocks_);
  at.normal_velocity_response = mobility * at.normal;
  at.normal_inverse_mass = at.normal.dot(at.normal_velocity_response);
  const double across = D == 2 ? mobility.trace() - at.normal_inverse_mass : mobility.norm();
  // Where supports of both blocks hold a contact, nothing moves across it, and friction only opposes the
  // slip.
  at.shear_inverse_mass = std::max(across, equal_within * at.normal_inverse_mass);
}

template <int D>
Vector<D> PointContactSearch<D>::face_of(std::size_t slot, int corner) const {
  if (blocks_.is_of_mesh(slot)) return outwards(slot, corner);
  const Outline<D> outline = blocks_.outline(std::int32_t(slot));
  Vector<D> sum = Vector<D>::Zero();
  for (int face = 0; face < outline.face_count(); ++face) {
    const double share = share_of_corner(outline, face, corner);
    if (share > 0) sum += share * halfspace::face_of(outline, face).area * outline.normal(face);
  }
  return sum;
}

template <int D>
double PointContactSearch<D>::area_of(const ContactConstraint<D>& at) const {
  if (at.meeting == Meeting::edges) return 0;
  const bool a_is_mesh = blocks_.is_of_mesh(std::size_t(at.a)),
             b_is_mesh = blocks_.is_of_mesh(std::size_t(at.b));
  const double share = a_is_mesh == b_is_mesh ? 0.5 : a_is_mesh ? 1 : 0;
  return share * std::max(0.0, -at.normal.dot(face_of(std::size_t(at.a), at.feature_a)));
}

/// At least the rounding of a corner's place seen from a block. Faces reach so far beyond their ends, so that
/// corners that meet squarely are not lost to rounding.
template <int D>
double PointContactSearch<D>::reach(std::size_t b) const {
  return std::max(face_reach * blocks_.radius[b], place_rounding * blocks_.position[b].norm());
}

/// Pairs that meet in points, as far as they come near each other at all.
template <int D>
void PointContactSearch<D>::find(Array<ContactConstraint<D>>& found) {
  found.clear();
  compute_node_normals();
  margin_ = 2 * integrator_.longest_motion();
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!model_.has_points(pair)) continue;
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const double reach = blocks_.radius[a] + blocks_.radius[b] + margin_ +
                         integrator_.predicted_displacement(a).norm() +
                         integrator_.predicted_displacement(b).norm();
    if ((blocks_.position[a] - blocks_.position[b]).squaredNorm() > reach * reach) continue;
    find_vertex_face(pair.a, pair.b, found);
    find_vertex_face(pair.b, pair.a, found);
    if constexpr (D == 3) find_edge_edge(pair.a, pair.b, found);
  }
  std::sort(found.begin(), found.end(),
            [](const ContactConstraint<D>& one, const ContactConstraint<D>& other) {
              return one.key() < other.key();
            });
  for (ContactConstraint<D>& at : found) place(at);
  // Supports of both blocks hold them along the normal.
  std::erase_if(found, [](const ContactConstraint<D>& at) { return !(at.normal_inverse_mass > 0); });
}

template <int D>
double PointContactSearch<D>::predicted_gap(const ContactConstraint<D>& at) const {
  if (at.meeting == Meeting::edges) return predicted_gap_of_edges(at);
  const Pose pose = predicted_pose(std::size_t(at.b));
  const Outline<D> own = blocks_.own_outline(at.b);
  const Vector<D> in_b = pose.inverse * (predicted_corner(std::size_t(at.a), at.feature_a) - pose.position);
  return (own.normal(at.feature_b).dot(in_b) - own.offset[at.feature_b]) /
         (pose.inverse.transpose() * own.normal(at.feature_b)).norm();
}

template class PointContactSearch<2>;
template class PointContactSearch<3>;

}  // namespace halfspace
