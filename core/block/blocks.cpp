#include "block/blocks.h"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int components = 5;

}  // namespace

Blocks<2>::Blocks(Memory* memory)
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
      torque(memory),
      applied_torque(memory),
      mass(memory),
      inertia(memory),
      radius(memory),
      longest_edge(memory),
      free_slots_(memory),
      first_(memory),
      vertex_count_(memory),
      own_(memory),
      turned_(memory) {}

void Blocks<2>::resize(std::size_t slots) {
  kind.resize(slots, BlockKind::none);
  material.resize(slots);
  generation.resize(slots);
  position.resize(slots, Vector<2>::Zero());
  velocity.resize(slots, Vector<2>::Zero());
  force.resize(slots, Vector<2>::Zero());
  applied_force.resize(slots, Vector<2>::Zero());
  rotation.resize(slots);
  angle.resize(slots);
  spin.resize(slots);
  torque.resize(slots);
  applied_torque.resize(slots);
  mass.resize(slots);
  inertia.resize(slots);
  radius.resize(slots);
  longest_edge.resize(slots);
  first_.resize(slots);
  vertex_count_.resize(slots);
}

std::int32_t Blocks<2>::add(const Shape<2>& shape, BlockKind block_kind, std::int32_t block_material,
                            double density) {
  // All memory first: when there is none, nothing has changed.
  const Outline<2> outline = shape.outline();
  const std::size_t stride = std::size_t(Outline<2>::padded(outline.count));
  const std::size_t first = own_.size();
  const bool appended = free_slots_.empty();
  const std::size_t slots = slot_count();
  const std::int32_t slot = appended ? std::int32_t(slots) : free_slots_.back();
  try {
    own_.resize(first + components * stride);
    turned_.resize(first + components * stride);
    if (appended) resize(slots + 1);
  } catch (...) {
    own_.resize(first);
    turned_.resize(first);
    if (appended) resize(slots);
    throw;
  }

  const std::size_t s = std::size_t(slot);
  if (!appended) free_slots_.pop_back();
  first_[s] = std::int64_t(first);
  vertex_count_[s] = outline.count;
  const double* component_of_shape[components] = {outline.x, outline.y, outline.nx, outline.ny,
                                                  outline.offset};
  for (int k = 0; k < components; ++k) {
    std::copy_n(component_of_shape[k], stride, own_.data() + first + std::size_t(k) * stride);
  }
  std::copy_n(outline.offset, stride, turned_.data() + first + 4 * stride);

  ++generation[s];
  ++living_;
  kind[s] = block_kind;
  material[s] = block_material;
  velocity[s] = force[s] = applied_force[s] = Vector<2>::Zero();
  spin[s] = torque[s] = applied_torque[s] = angle[s] = 0;
  mass[s] = density * shape.area();
  inertia[s] = density * shape.polar_moment();
  radius[s] = shape.bounding_radius();
  longest_edge[s] = shape.longest_edge();
  place(slot, shape.centroid(), Rotation<2>());
  return slot;
}

void Blocks<2>::remove(std::int32_t slot) {
  free_slots_.push_back(slot);  // the one line that may fail comes first
  drop_outline(slot);
  kind[std::size_t(slot)] = BlockKind::none;
  --living_;
}

/// Closes the gap that a removed block leaves in the outlines.
void Blocks<2>::drop_outline(std::int32_t slot) {
  const std::int64_t first = first_[std::size_t(slot)];
  const std::int64_t length = components * Outline<2>::padded(vertex_count_[std::size_t(slot)]);
  own_.erase(own_.begin() + first, own_.begin() + first + length);
  turned_.erase(turned_.begin() + first, turned_.begin() + first + length);
  for (std::int64_t& other : first_) {
    if (other > first) other -= length;
  }
}

void Blocks<2>::place(std::int32_t slot, const Vector<2>& to, const Rotation<2>& turned) {
  position[std::size_t(slot)] = to;
  rotation[std::size_t(slot)] = turned;
  turn_outline(slot);
}

void Blocks<2>::turn_outline(std::int32_t slot) {
  const std::size_t s = std::size_t(slot);
  const std::size_t stride = std::size_t(Outline<2>::padded(vertex_count_[s]));
  const double* own = own_.data() + first_[s];
  double* turned = turned_.data() + first_[s];
  const double c = rotation[s].cosine, sn = rotation[s].sine;
  // Vertices (components 0, 1), then normals (2, 3).
  for (std::size_t xy = 0; xy < 4 * stride; xy += 2 * stride) {
    const double* x = own + xy;
    const double* y = x + stride;
    double* out_x = turned + xy;
    double* out_y = out_x + stride;
    for (std::size_t i = 0; i < stride; ++i) {
      out_x[i] = c * x[i] - sn * y[i];
      out_y[i] = sn * x[i] + c * y[i];
    }
  }
}

Outline<2> Blocks<2>::outline(std::int32_t slot) const {
  const int count = vertex_count_[std::size_t(slot)];
  const int stride = Outline<2>::padded(count);
  const double* p = turned_.data() + first_[std::size_t(slot)];
  return {count, p, p + stride, p + 2 * stride, p + 3 * stride, p + 4 * stride};
}

Box<2> Blocks<2>::box(std::int32_t slot) const {
  const Outline<2> o = outline(slot);
  const auto [least_x, most_x] = std::minmax_element(o.x, o.x + o.count);
  const auto [least_y, most_y] = std::minmax_element(o.y, o.y + o.count);
  const Vector<2>& p = position[std::size_t(slot)];
  return {p + Vector<2>(*least_x, *least_y), p + Vector<2>(*most_x, *most_y)};
}

}  // namespace halfspace
