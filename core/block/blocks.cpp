#include "block/blocks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.h"
#include "geometry/deformed_outline.h"
#include "geometry/numbers.h"

namespace halfspace {
namespace {

double largest_face_of(const Shape<2>& shape) { return shape.longest_edge(); }
double largest_face_of(const Shape<3>& shape) { return shape.largest_face(); }

/// A force f at X accelerates the gradient by f X^T M^-1, and X by that times X: maximum at a vertex.
template <int D>
double strain_mobility_of(const Outline<D>& own, const Tensor<D>& inverse_mass_matrix) {
  double most = 0;
  for (int i = 0; i < own.vertex_count(); ++i)
    most = std::max(most, own.vertex(i).dot(inverse_mass_matrix * own.vertex(i)));
  return most;
}

/// The smallest eigenvalue of a symmetric tensor; in 2D the determinant divided by the largest eigenvalue.
double least_eigenvalue(const Tensor<2>& t) {
  const double mean = 0.5 * (t(0, 0) + t(1, 1));
  const double difference = 0.5 * (t(0, 0) - t(1, 1)) / mean, across = t(0, 1) / mean;
  const double largest = mean * (1 + std::sqrt(difference * difference + across * across));
  return t(0, 0) * (t(1, 1) / largest) - t(0, 1) * (t(0, 1) / largest);
}
double least_eigenvalue(const Tensor<3>& t) {
  return Eigen::SelfAdjointEigenSolver<Tensor<3>>(t, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// Scaled by a power of two, which is exact: the determinant is a square or cube of the entries and could
/// overflow or underflow.
template <int D>
Tensor<D> inverse_of(const Tensor<D>& t) {
  int exponent = 0;
  std::frexp(t.cwiseAbs().maxCoeff(), &exponent);
  const double scale = std::ldexp(1.0, -exponent);
  return scale * (scale * t).inverse();
}

/// The deformation of a new block: none.
template <int D>
Deformation<D> undeformed(const Shape<D>& shape, double density, std::int32_t slot) {
  Deformation<D> deformation;
  deformation.slot = slot;
  deformation.volume = mass_of(shape, 1);
  deformation.mass_matrix = density * second_moment_of(shape);
  deformation.inverse_mass_matrix = inverse_of<D>(deformation.mass_matrix);
  deformation.least_moment = least_eigenvalue(deformation.mass_matrix);
  deformation.strain_mobility = strain_mobility_of(shape.outline(), deformation.inverse_mass_matrix);
  return deformation;
}

Box<2> box_of(const Outline<2>& o) {
  const auto [least_x, most_x] = std::minmax_element(o.x, o.x + o.count);
  const auto [least_y, most_y] = std::minmax_element(o.y, o.y + o.count);
  return {{*least_x, *least_y}, {*most_x, *most_y}};
}

Box<3> box_of(const Outline<3>& o) {
  const int count = o.vertex_count();
  const auto [least_x, most_x] = std::minmax_element(o.x, o.x + count);
  const auto [least_y, most_y] = std::minmax_element(o.y, o.y + count);
  const auto [least_z, most_z] = std::minmax_element(o.z, o.z + count);
  return {{*least_x, *least_y, *least_z}, {*most_x, *most_y, *most_z}};
}

template <int D>
bool is_turn(const Rotation<D>& rotation) {
  const Tensor<D> turn = rotation.tensor();
  return (turn.transpose() * turn - Tensor<D>::Identity()).norm() <= 1e-6;
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
  material.resize(slots);
  generation.resize(slots);
  position.resize(slots, Vector<D>::Zero());
  velocity.resize(slots, Vector<D>::Zero());
  force.resize(slots, Vector<D>::Zero());
  applied_force.resize(slots, Vector<D>::Zero());
  rotation.resize(slots);
  if constexpr (D == 2) angle.resize(slots);
  spin.resize(slots, Angular<D>::Zero());
  momentum.resize(slots, Angular<D>::Zero());
  torque.resize(slots, Angular<D>::Zero());
  applied_torque.resize(slots, Angular<D>::Zero());
  mass.resize(slots);
  inertia.resize(slots);
  radius.resize(slots);
  largest_face.resize(slots);
  thickness.resize(slots);
  held.resize(slots);
  outlines_.resize(slots);
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
  material[s] = block_material;
  force[s] = applied_force[s] = Vector<D>::Zero();
  torque[s] = applied_torque[s] = Angular<D>::Zero();
  if constexpr (D == 2) angle[s] = 0;
  rotation[s] = Rotation<D>();
  spin[s] = Angular<D>::Zero();
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
  held[s] = 0;
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
  kind[std::size_t(slot)] = BlockKind::none;
  --living_;
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
  kind[s] = BlockKind::none;
  --living_;
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
void Blocks<D>::drift(std::int32_t slot, const Vector<D>& way, const Rotation<D>& turned) {
  const std::size_t s = std::size_t(slot);
  position[s] += way;
  if (kind[s] == BlockKind::rigid) spin[s] = inertia[s].spin(momentum[s], turned);
  if (spin[s] == Angular<D>::Zero()) return;
  rotation[s] = turned;
  outlines_.turn(slot, turned);
}

template <int D>
void Blocks<D>::deform(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate) {
  const std::size_t s = std::size_t(slot);
  deformation(s).gradient = gradient;
  deformation(s).rate = rate;
  set_rotation(s, rotation_of(gradient));
  outlines_.deform(slot, gradient);
  renew_spin(s);
}

template <int D>
void Blocks<D>::renew_spin(std::size_t slot) {
  Deformation<D>& now = deformation(slot);
  const Tensor<D> velocity_gradient = now.velocity_gradient();
  now.strain_rate = 0.5 * (velocity_gradient + velocity_gradient.transpose());
  spin[slot] = 0.5 * moment(velocity_gradient);
  momentum[slot] = now.angular_momentum();
}

template <int D>
void Blocks<D>::drift_affine(std::int32_t slot, const Vector<D>& way, double duration) {
  const std::size_t s = std::size_t(slot);
  const Deformation<D>& now = deformation(s);
  position[s] += way;
  deform(slot, now.gradient + duration * now.rate, now.rate);
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
void Blocks<D>::follow_nodes(const SurfaceCell<D>& cell) {
  const std::size_t s = std::size_t(cell.block);
  position[s] = meshes_.body(cell.body).origin + cell.mean_of(meshes_.place);
  velocity[s] = cell.mean_of(meshes_.velocity);
  deform(cell.block, cell.gradient_of(meshes_.place), cell.gradient_of(meshes_.velocity));
}

template <int D>
void Blocks<D>::follow_node_velocities(const SurfaceCell<D>& cell) {
  const std::size_t s = std::size_t(cell.block);
  velocity[s] = cell.mean_of(meshes_.velocity);
  deformation(s).rate = cell.gradient_of(meshes_.velocity);
  renew_spin(s);
}

template <int D>
std::int32_t Blocks<D>::add_compound(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                                     BlockKind block_kind, std::int32_t block_material, double density) {
  const CompoundBody<D> body = compound_body(shapes, poses, density);
  compounds_.make_room(shapes.size(), slot_count() + shapes.size() + 1);
  const std::int32_t compound = occupy(outlines_.take_in_none(), block_kind, block_material);
  const std::size_t c = std::size_t(compound);
  mass[c] = body.mass;
  inertia[c] = body.inertia;
  radius[c] = body.radius;
  largest_face[c] = 0;
  thickness[c] = body.radius;
  compounds_.add(compound);
  try {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      Part<D> part;
      part.pose = {poses[i].position - body.centroid, poses[i].rotation};
      part.block = add(*shapes[i], block_kind, block_material, density);
      part.compound = compound;
      compounds_.add(part);
      largest_face[c] = std::max(largest_face[c], largest_face[std::size_t(part.block)]);
      thickness[c] = std::min(thickness[c], thickness[std::size_t(part.block)]);
    }
  } catch (...) {
    take_back_compound(compound);
    throw;
  }
  place(compound, Vector<D>::Zero(), Rotation<D>());
  set_motion(compound, Vector<D>::Zero(), Angular<D>::Zero());
  return compound;
}

template <int D>
void Blocks<D>::take_back_compound(std::int32_t compound) {
  const std::span<const Part<D>> parts = compounds_.parts_of(std::size_t(compound));
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) take_back(part->block);
  compounds_.remove(compound);
  take_back(compound);
}

template <int D>
void Blocks<D>::remove_compound(std::int32_t compound) {
  compounds_.remove(compound);
  remove(compound);
}

template <int D>
void Blocks<D>::follow(std::int32_t compound) {
  for (const Part<D>& part : compounds_.parts_of(std::size_t(compound))) follow(part);
}

template <int D>
void Blocks<D>::follow_velocity(std::int32_t compound) {
  for (const Part<D>& part : compounds_.parts_of(std::size_t(compound))) follow_velocity(part);
}

template <int D>
void Blocks<D>::follow(const Part<D>& part) {
  const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
  position[p] = position[c] + rotation[c] * part.pose.position;
  set_rotation(p, rotation[c] * part.pose.rotation);
  outlines_.turn(part.block, rotation[p]);
  follow_velocity(part);
}

template <int D>
void Blocks<D>::follow_velocity(const Part<D>& part) {
  const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
  velocity[p] = velocity_at(c, position[p] - position[c]);
  spin[p] = spin[c];
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
    if (!lives(slot)) continue;
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
std::size_t Blocks<D>::most_edges() const {
  int most = 0;
  for (std::size_t slot = 0; slot < slot_count(); ++slot) {
    if (lives(slot)) most = std::max(most, outline(std::int32_t(slot)).edge_count());
  }
  return std::size_t(most);
}

template <int D>
std::size_t Blocks<D>::most_components() const {
  std::size_t most = 0;
  for (std::size_t slot = 0; slot < slot_count(); ++slot) {
    if (lives(slot)) most = std::max(most, component_count(own_outline(std::int32_t(slot))));
  }
  return most;
}

template <int D>
bool Blocks<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t slots = slot_count();
  const std::size_t sizes[] = {
      material.size(),  generation.size(),     position.size(),       velocity.size(), force.size(),
      rotation.size(),  applied_force.size(),  spin.size(),           momentum.size(), torque.size(),
      mass.size(),      applied_torque.size(), inertia.size(),        radius.size(),   largest_face.size(),
      thickness.size(), held.size(),           outlines_.slot_count()};
  if (std::any_of(std::begin(sizes), std::end(sizes), [&](std::size_t size) { return size != slots; }))
    return false;
  if (angle.size() != (D == 2 ? slots : 0)) return false;
  Array<std::int32_t> living(kind.get_allocator().resource());
  for (std::size_t i = 0; i < slots; ++i) {
    if (kind[i] == BlockKind::none) continue;
    living.push_back(std::int32_t(i));
    if (kind[i] < BlockKind::fixed || kind[i] > BlockKind::mesh) return false;
    if (material[i] < 0 || material[i] >= material_count) return false;
    const bool is_placed = all_finite(position[i]) && is_turn<D>(rotation[i]);
    // That of a deformable block follows from its deformation.
    const bool has_momentum = is_deformable(i) || all_finite(momentum[i]);
    const bool moves = all_finite(velocity[i]) && all_finite(spin[i]) && has_momentum;
    const bool is_driven = all_finite(applied_force[i]) && all_finite(applied_torque[i]);
    const bool resists = is_positive(mass[i]) && is_positive(inertia[i].least_moment());
    if (!(is_placed && moves && is_driven && resists)) return false;
    if (held[i] >= 2 << D || (held[i] != 0 && kind[i] != BlockKind::rigid)) return false;
    if (!is_positive(radius[i]) || !is_finite(thickness[i])) return false;
  }
  Array<std::uint8_t> is_taken(slots, 0, kind.get_allocator());
  const auto is_free = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && !lives(std::size_t(slot)) &&
           !is_taken[std::size_t(slot)]++;
  };
  const auto has_its_outline = [&](std::int32_t slot) {
    return (own_outline(slot).vertex_count() == 0) == is_compound(std::size_t(slot));
  };
  const auto is_like_its_compound = [&](const Part<D>& part) {
    const BlockKind of_compound = kind[std::size_t(part.compound)];
    return of_compound != BlockKind::none && of_compound <= BlockKind::rigid &&
           kind[std::size_t(part.block)] == of_compound && is_turn<D>(part.pose.rotation);
  };
  const auto is_on_surface = [&](const SurfaceCell<D>& cell) {
    return std::size_t(cell.block) < slots && is_of_mesh(std::size_t(cell.block)) &&
           own_outline(cell.block).vertex_count() == D + 1;
  };
  const auto joins_living = [&](const Bond<D>& bond) {
    return bond.a < 0 || (lives(std::size_t(bond.a)) && lives(std::size_t(bond.b)));
  };
  return std::int64_t(living.size()) == living_ &&
         std::count(held.begin(), held.end(), 0) == std::ptrdiff_t(slots) - held_count_ &&
         free_slots_.size() == slots - living.size() && all(free_slots_, is_free) &&
         outlines_.is_consistent(living) && compounds_.is_consistent(slots) && all(living, has_its_outline) &&
         all(compounds_.parts(), is_like_its_compound) &&
         all(deformations_.all(), [](const Deformation<D>& d) { return d.is_consistent(); }) &&
         deformations_.is_consistent(slots, [&](std::size_t slot) { return is_deformable(slot); }) &&
         bonds_.is_consistent(slots) && all(bonds_.all(), joins_living) &&
         meshes_.is_consistent(material_count) && all(meshes_.surface(), is_on_surface) &&
         std::count(kind.begin(), kind.end(), BlockKind::mesh) == std::ptrdiff_t(meshes_.surface().size());
}

template class Blocks<2>;
template class Blocks<3>;

}  // namespace halfspace
