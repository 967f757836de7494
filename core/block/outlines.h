#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "block/block_state.h"
#include "block/topologies.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/vector.h"

namespace halfspace {

/// The outlines of a world's blocks by slot, relative to the centroid: in the frame of the shape, and at the
/// present rotation or deformation. The data of one block is contiguous.
template <int D>
class Outlines {
 public:
  explicit Outlines(Memory* memory)
      : first_(memory), form_(memory), own_(memory), turned_(memory), topologies_(memory) {}

  void resize(std::size_t slots) {
    first_.resize(slots);
    form_.resize(slots);
  }
  std::size_t slot_count() const { return first_.size(); }

  /// A shape's outline for a new block, not yet assigned to a slot.
  struct Taken {
    std::int64_t first;
    std::int32_t form;
  };
  Taken take_in(const Shape<D>& shape) { return take_in(shape.outline()); }
  /// Precondition: the copy is complete.
  Taken take_in(const OutlineCopy<D>& copy);
  /// An outline without vertices, for a block that makes no contacts of its own.
  Taken take_in_none();
  void assign(std::int32_t slot, const Taken& taken);
  void undo(const Taken& taken);
  /// The same for the block added last.
  void take_back(std::int32_t slot) { undo({first_[std::size_t(slot)], form_[std::size_t(slot)]}); }
  void copy(std::int32_t slot, OutlineCopy<D>& to) const;
  /// Is a complete copy that of a closed convex surface, as far as its topology tells?
  bool is_sound(const OutlineCopy<D>& copy) const;
  // Taking over outlines of another world, between begin and end.
  void begin_taking_over(const Outlines& other, std::size_t count);
  Taken take_over(const Outlines& other, std::int32_t slot);
  void end_taking_over();
  /// Closes the gap of a removed block.
  void drop(std::int32_t slot);

  void turn(std::int32_t slot, const Rotation<D>& rotation);
  /// Vertices are mapped by the gradient, half-spaces so that they remain those of the faces.
  void deform(std::int32_t slot, const Tensor<D>& gradient);
  /// Valid until a block is added or removed.
  Outline<D> operator[](std::int32_t slot) const { return seen_in(turned_, slot); }
  /// In the frame of the shape.
  Outline<D> own(std::int32_t slot) const { return seen_in(own_, slot); }

  /// False for data of a damaged snapshot, given the slots of the living blocks.
  bool is_consistent(std::span<const std::int32_t> living) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(first_, form_, own_, turned_);
    if constexpr (D == 3) archive(topologies_);
  }

 private:
  struct NoTopologies {
    explicit NoTopologies(Memory*) {}
  };

  Taken take_in(const Outline<D>& outline);
  Outline<D> seen_in(const Array<double>& components, std::int32_t slot) const;
  void map(std::int32_t slot, const Tensor<D>& vertices, const Tensor<D>& normals);
  bool is_form(std::int32_t form) const;
  bool counts_users(std::span<const std::int32_t> living) const;
  std::size_t length(std::int32_t form) const;

  Array<std::int64_t> first_;  // index of the block's components in own_ and turned_
  Array<std::int32_t> form_;   // in 2D the number of vertices, in 3D the index of the topology
  // Per block x, y, nx, ny, offset, or x, y, z, nx, ny, nz, offset, each padded.
  Array<double> own_;
  Array<double> turned_;
  [[no_unique_address]] std::conditional_t<D == 3, Topologies, NoTopologies> topologies_;
};

/// The outline with these components.
inline Outline<2> outline_at(int vertices, const double* components) {
  const std::size_t n = std::size_t(Outline<2>::padded(vertices));
  return {vertices, components, components + n, components + 2 * n, components + 3 * n, components + 4 * n};
}
inline Outline<3> outline_at(const Topology& topology, const double* components) {
  const std::size_t v = std::size_t(Outline<3>::padded(topology.vertex_count)),
                    f = std::size_t(Outline<3>::padded(topology.face_count));
  const double* normals = components + 3 * v;
  return {&topology, components,  components + v,  components + 2 * v,
          normals,   normals + f, normals + 2 * f, normals + 3 * f};
}

// Inline, as detection reads two outlines per pair and step.
template <>
inline Outline<2> Outlines<2>::seen_in(const Array<double>& components, std::int32_t slot) const {
  return outline_at(form_[std::size_t(slot)], components.data() + first_[std::size_t(slot)]);
}
template <>
inline Outline<3> Outlines<3>::seen_in(const Array<double>& components, std::int32_t slot) const {
  return outline_at(topologies_[form_[std::size_t(slot)]], components.data() + first_[std::size_t(slot)]);
}
template <>
bool Outlines<2>::is_form(std::int32_t form) const;
template <>
bool Outlines<3>::is_form(std::int32_t form) const;
template <>
bool Outlines<2>::counts_users(std::span<const std::int32_t> living) const;
template <>
bool Outlines<3>::counts_users(std::span<const std::int32_t> living) const;
template <>
Outlines<2>::Taken Outlines<2>::take_in(const OutlineCopy<2>& copy);
template <>
Outlines<3>::Taken Outlines<3>::take_in(const OutlineCopy<3>& copy);
template <>
bool Outlines<2>::is_sound(const OutlineCopy<2>& copy) const;
template <>
bool Outlines<3>::is_sound(const OutlineCopy<3>& copy) const;
template <>
void Outlines<2>::copy(std::int32_t slot, OutlineCopy<2>& to) const;
template <>
void Outlines<3>::copy(std::int32_t slot, OutlineCopy<3>& to) const;
template <>
std::size_t Outlines<2>::length(std::int32_t form) const;
template <>
std::size_t Outlines<3>::length(std::int32_t form) const;

}  // namespace halfspace
