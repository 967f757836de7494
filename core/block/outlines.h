#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

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
  Taken take_in(const Shape<D>& shape);
  /// An outline without vertices, for a block that makes no contacts of its own.
  Taken take_in_none();
  void assign(std::int32_t slot, const Taken& taken);
  void undo(const Taken& taken);
  /// The same for the block added last.
  void take_back(std::int32_t slot) { undo({first_[std::size_t(slot)], form_[std::size_t(slot)]}); }
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

// Inline, as detection reads two outlines per pair and step.
template <>
inline Outline<2> Outlines<2>::seen_in(const Array<double>& components, std::int32_t slot) const {
  const int count = form_[std::size_t(slot)];
  const std::size_t n = std::size_t(Outline<2>::padded(count));
  const double* p = components.data() + first_[std::size_t(slot)];
  return {count, p, p + n, p + 2 * n, p + 3 * n, p + 4 * n};
}
template <>
inline Outline<3> Outlines<3>::seen_in(const Array<double>& components, std::int32_t slot) const {
  const Topology& topology = topologies_[form_[std::size_t(slot)]];
  const std::size_t v = std::size_t(Outline<3>::padded(topology.vertex_count)),
                    f = std::size_t(Outline<3>::padded(topology.face_count));
  const double* p = components.data() + first_[std::size_t(slot)];
  const double* n = p + 3 * v;
  return {&topology, p, p + v, p + 2 * v, n, n + f, n + 2 * f, n + 3 * f};
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
std::size_t Outlines<2>::length(std::int32_t form) const;
template <>
std::size_t Outlines<3>::length(std::int32_t form) const;

}  // namespace halfspace
