#include "block/blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.h"
#include "geometry/deformed_outline.h"

namespace halfspace {
namespace {

double largest_face_of(const Shape<2>& shape) { return shape.longest_edge(); }
double largest_face_of(const Shape<3>& shape) { return shape.largest_face(); }

template <class T>
T entry_of_none(const Array<T>&) {
  if constexpr (requires { T::Zero(); }) {
    return T::Zero();
  } else {
    return T();
  }
}

Box<2> box_of(const Outline<2>& o) {
  const auto [min_x, max_x] = std::minmax_element(o.x, o.x + o.count);
  const auto [min_y, max_y] = std::minmax_element(o.y, o.y + o.count);
  return {{*min_x, *min_y}, {*max_x, *max_y}};
}

Box<3> box_of(const Outline<3>& o) {
  const int count = o.vertex_count();
  const auto [min_x, max_x] = std::minmax_element(o.x, o.x + count);
  const auto [min_y, max_y] = std::minmax_element(o.y, o.y + count);
  const auto [min_z, max_z] = std::minmax_element(o.z, o.z + count);
  return {{*min_x, *min_y, *min_z}, {*max_x, *max_y, *max_z}};
}

}  // namespace

template <int D>
Blocks<D>::Blocks(Memory* memory)
    : kind(memory),
      material(memory),
      generation(memory),
      position(memory),
      velocity(memory),
      force(memory),
      applied_force(memory),
      rotation(memory),
      angle(memory),
      spin(memory),
      mean_spin(memory),
      momentum(memory),
      torque(memory),
      applied_torque(memory),
      mass(memory),
      inertia(memory),
      radius(memory),
      largest_face(memory),
      thickness(memory),
      held(memory),
      free_slots_(memory),
      outlines_(memory),
      deformations_(memory),
      compounds_(memory),
      meshes_(memory),
      bonds_(memory) {}

template <int D>
void Blocks<D>::resize(std::size_t slots) {
  if (free_slots_.capacity() < slots) free_slots_.reserve(2 * slots);  // so remove() allocates nothing
  kind.resize(slots, BlockKind::none);
  generation.resize(slots);
  const auto fit = [&](auto& array) { array.resize(slots, entry_of_none(array)); };
  std::apply([&](auto&... arrays) { (fit(arrays), ...); }, entries());
  if constexpr (D == 2) angle.resize(slots);
  outlines_.resize(slots);
}

/// A free slot has the entries of one that has never been used, whatever has been in it: so a block that is
/// taken back leaves nothing behind.
template <int D>
void Blocks<D>::empty(std::size_t slot) {
  kind[slot] = BlockKind::none;
  const auto empty_entry = [&](auto& array) { array[slot] = entry_of_none(array); };
  std::apply([&](auto&... arrays) { (empty_entry(arrays), ...); }, entries());
  if constexpr (D == 2) angle[slot] = 0;
  outlines_.assign(std::int32_t(slot), {});
  --living_;
  while (moving_end_ > 0 && !moves(moving_end() - 1)) --moving_end_;
}

template <int D>
double Blocks<D>::strain_mobility(std::size_t slot) const {
  if (is_deformable(slot)) return deformation(slot).strain_mobility;
  double most = 0;
  const auto note = [&](const Vector<D>& arm) { most = std::max(most, inertia[slot].yield_at(arm)); };
  const Outline<D> own = outlines_.own(std::int32_t(slot));
  for (int i = 0; i < own.vertex_count(); ++i) note(own.vertex(i));
  if (!is_compound(slot)) return most;
  for (const Part<D>& part : compounds_.parts_of(slot)) {
    const Outline<D> of_part = outlines_.own(part.block);
    for (int i = 0; i < of_part.vertex_count(); ++i)
      note(part.pose.position + part.pose.rotation * of_part.vertex(i));
  }
  return most;
}

template <int D>
void Blocks<D>::begin_taking_over(const Blocks& other, std::size_t count) {
  free_slots_.reserve(count);
  kind.reserve(count);
  generation.reserve(count);
  std::apply([&](auto&... arrays) { (arrays.reserve(count), ...); }, entries());
  if constexpr (D == 2) angle.reserve(count);
  outlines_.begin_taking_over(other.outlines_, count);
}

/// Allocates first: when memory runs out, nothing has changed, and the outline is given back.
template <int D>
std::int32_t Blocks<D>::occupy(const typename Outlines<D>::Taken& outline, BlockKind block_kind,
                               std::int32_t block_material) {
  const bool appended = free_slots_.empty();
  const std::size_t slots = slot_count();
  const std::int32_t slot = appended ? std::int32_t(slots) : free_slots_.back();
  try {
    if (appended) resize(slots + 1);
    if (block_kind >= BlockKind::affine) deformations_.make_room(slots + 1);
  } catch (...) {
    outlines_.undo(outline);
    resize(slots);
    throw;
  }

  const std::size_t s = std::size_t(slot);
  if (!appended) free_slots_.pop_back();
  outlines_.assign(slot, outline);
  ++generation[s];
  ++living_;
  kind[s] = block_kind;
  if (moves(s)) moving_end_ = std::max(moving_end_, std::int64_t(slot) + 1);
  material[s] = block_material;
  return slot;
}

template <int D>
std::int32_t Blocks<D>::add(const Shape<D>& shape, BlockKind block_kind, std::int32_t block_material,
                            double density) {
  const std::int32_t slot = occupy(outlines_.take_in(shape), block_kind, block_material);
  const std::size_t s = std::size_t(slot);
  mass[s] = mass_of(shape, density);
  inertia[s] = Inertia<D>::of(shape, density);
  radius[s] = shape.bounding_radius();
  largest_face[s] = largest_face_of(shape);
  thickness[s] = shape.thickness();
  if (block_kind >= BlockKind::affine) deformations_.add(undeformed(shape, density, slot));
  place(slot, shape.centroid(), Rotation<D>());
  set_motion(slot, Vector<D>::Zero(), Angular<D>::Zero());
  return slot;
}

template <int D>
void Blocks<D>::remove(std::int32_t slot) {
  hold(std::size_t(slot), 0);
  free_slots_.push_back(slot);
  outlines_.drop(slot);
  if (is_deformable(std::size_t(slot))) deformations_.remove(slot);
  bonds_.forget(slot);
  empty(std::size_t(slot));
}

/// A block whose rotation is held does not rotate.
template <int D>
void Blocks<D>::hold(std::size_t slot, std::uint8_t components) {
  held_count_ += (components != 0) - (held[slot] != 0);
  held[slot] = components;
  if (is_held(slot, D)) set_motion(std::int32_t(slot), velocity[slot], Angular<D>::Zero());
}

/// A slot of generation 1 was appended with its block and is removed; any other becomes free again.
template <int D>
void Blocks<D>::take_back(std::int32_t slot) {
  const std::size_t s = std::size_t(slot);
  outlines_.take_back(slot);
  if (is_deformable(s)) deformations_.remove(slot);
  empty(s);
  if (--generation[s] == 0) {
    resize(s);
  } else {
    free_slots_.push_back(slot);
  }
}

template <int D>
void Blocks<D>::place(std::int32_t slot, const Vector<D>& to, const Rotation<D>& turned) {
  const std::size_t s = std::size_t(slot);
  position[s] = to;
  if (is_deformable(s)) {
    // A rigid rotation: strain and strain rate rotate with the block.
    const Deformation<D>& now = deformation(s);
    const Tensor<D> turn = (turned * rotation[s].inverse()).tensor(), gradient = turn * now.gradient;
    const Tensor<D> straining = now.rate - cross_tensor(spin[s]) * now.gradient;
    deform(slot, gradient, cross_tensor(spin[s]) * gradient + turn * straining);
    return set_rotation(s, turned);
  }
  set_rotation(s, turned);
  momentum[s] = inertia[s].momentum(spin[s], turned);
  outlines_.turn(slot, turned);
  if (is_compound(s)) follow(slot);
}

/// The angle stays continuous: whole turns are counted.
template <int D>
void Blocks<D>::set_rotation(std::size_t slot, const Rotation<D>& turned) {
  rotation[slot] = turned;
  if constexpr (D == 2) {
    constexpr double whole_turn = 2 * std::numbers::pi;
    const double within_a_turn = angle_at(turned.cosine, turned.sine);
    angle[slot] = within_a_turn + whole_turn * std::round((angle[slot] - within_a_turn) / whole_turn);
  }
}

template <int D>
void Blocks<D>::set_motion(std::int32_t slot, const Vector<D>& new_velocity, const Angular<D>& new_spin) {
  const std::size_t s = std::size_t(slot);
  velocity[s] = new_velocity;
  if (is_deformable(s)) {
    // The strain rate stays.
    const Deformation<D>& now = deformation(s);
    const Angular<D> change = new_spin - spin[s];
    return deform(slot, now.gradient, now.rate + cross_tensor(change) * now.gradient);
  }
  spin[s] = new_spin;
  momentum[s] = inertia[s].momentum(new_spin, rotation[s]);
  if (is_compound(s)) follow_velocity(slot);
}

template <int D>
void Blocks<D>::drift(std::int32_t slot, const Vector<D>& way, const Rotation<D>& turned, double duration) {
  const std::size_t s = std::size_t(slot);
  position[s] += way;
  if (kind[s] == BlockKind::rigid) spin[s] = inertia[s].spin(momentum[s], turned);
  mean_spin[s].setZero();
  if (spin[s] == Angular<D>::Zero()) return;
  mean_spin[s] = 2 / duration * turned.half_tangent_since(rotation[s]);
  rotation[s] = turned;
  outlines_.turn(slot, turned);
}

template <int D>
void Blocks<D>::deform(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate, double duration) {
  const std::size_t s = std::size_t(slot);
  deformation(s).gradient = gradient;
  deformation(s).rate = rate;
  set_rotation(s, rotation_of(gradient));
  outlines_.deform(slot, gradient);
  renew_spin(s, duration);
  mean_spin[s] = spin[s];
}

/// After a motion both are those of its middle: there a rotation is without strain.
template <int D>
void Blocks<D>::renew_spin(std::size_t slot, double duration) {
  Deformation<D>& now = deformation(slot);
  const Tensor<D> velocity_gradient = now.velocity_gradient(0.5 * duration);
  now.strain_rate = 0.5 * (velocity_gradient + velocity_gradient.transpose());
  spin[slot] = 0.5 * moment(velocity_gradient);
  momentum[slot] = now.angular_momentum();
}

template <int D>
void Blocks<D>::drift_affine(std::int32_t slot, const Vector<D>& way, double duration) {
  const std::size_t s = std::size_t(slot);
  const Deformation<D>& now = deformation(s);
  position[s] += way;
  deform(slot, now.gradient + duration * now.rate, now.rate, duration);
}

/// The largest inverse effective mass is that of the node with the smallest mass.
template <int D>
void Blocks<D>::weigh(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses) {
  const std::size_t s = std::size_t(cell.block);
  mass[s] = masses.sum();
  deformation(s).strain_mobility = 1 / masses.minCoeff() - 1 / mass[s];
}

template <int D>
void Blocks<D>::put_on_surface(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses) {
  weigh(cell, masses);
  meshes_.add_to_surface(cell);
  follow_nodes(cell);
}

template <int D>
void Blocks<D>::follow_nodes(const SurfaceCell<D>& cell, double duration) {
  const std::size_t s = std::size_t(cell.block);
  position[s] = meshes_.body(cell.body).origin + cell.mean_of(meshes_.place);
  velocity[s] = cell.mean_of(meshes_.velocity);
  deform(cell.block, cell.gradient_of(meshes_.place), cell.gradient_of(meshes_.velocity), duration);
}

template <int D>
void Blocks<D>::follow_node_velocities(const SurfaceCell<D>& cell) {
  const std::size_t s = std::size_t(cell.block);
  velocity[s] = cell.mean_of(meshes_.velocity);
  deformation(s).rate = cell.gradient_of(meshes_.velocity);
  renew_spin(s);
}

template <int D>
Box<D> Blocks<D>::box(std::int32_t slot) const {
  const Box<D> about_centroid = box_of(outline(slot));
  const Vector<D>& p = position[std::size_t(slot)];
  return {p + about_centroid.lower, p + about_centroid.upper};
}

template <int D>
std::int32_t Blocks<D>::containing(const Vector<D>& place) const {
  std::int32_t deepest = -1;
  double least = 0;
  for (std::size_t slot = 0; slot < slot_count(); ++slot) {
    if (!lives(slot) || is_compound(slot)) continue;  // a compound has no outline of its own
    const Outline<D> outline = this->outline(std::int32_t(slot));
    const Vector<D> arm = place - position[slot];
    double height = -HUGE_VAL;
    for (int f = 0; f < outline.face_count(); ++f)
      height = std::max(height, outline.normal(f).dot(arm) - outline.offset[f]);
    if (height > least || (height == least && deepest >= 0)) continue;
    deepest = std::int32_t(slot);
    least = height;
  }
  return deepest;
}

template <int D>
std::size_t Blocks<D>::max_edges() const {
  int most = 0;
  for (std::size_t slot = 0; slot < slot_count(); ++slot) {
    if (lives(slot)) most = std::max(most, outline(std::int32_t(slot)).edge_count());
  }
  return std::size_t(most);
}

template <int D>
std::size_t Blocks<D>::max_components() const {
  std::size_t most = 0;
  for (std::size_t slot = 0; slot < slot_count(); ++slot) {
    if (lives(slot)) most = std::max(most, component_count(own_outline(std::int32_t(slot))));
  }
  return most;
}

template class Blocks<2>;
template class Blocks<3>;

}  // namespace halfspace
