#include "block/outlines.h"

#include <algorithm>
#include <cmath>

#include "block/tiling.h"
#include "geometry/deformed_outline.h"
#include "geometry/polyhedron/topology.h"

namespace halfspace {
namespace {

/// The sizes of an outline's arrays, in doubles.
struct Extent {
  std::size_t vertices;    // per coordinate
  std::size_t halfspaces;  // per component of a normal, and of the offset
  int dimension;

  std::size_t offset() const { return std::size_t(dimension) * (vertices + halfspaces); }
  std::size_t length() const { return offset() + halfspaces; }
};

Extent extent_of(int vertex_count) {
  const std::size_t padded = std::size_t(Outline<2>::padded(vertex_count));
  return {padded, padded, 2};
}

Extent extent_of(const Topology& topology) {
  return {std::size_t(Outline<3>::padded(topology.vertex_count)),
          std::size_t(Outline<3>::padded(topology.face_count)), 3};
}

Extent extent_of(const Outline<2>& outline) { return extent_of(outline.count); }
Extent extent_of(const Outline<3>& outline) { return extent_of(*outline.topology); }

void copy_components(const Outline<2>& outline, double* to) {
  const Extent extent = extent_of(outline);
  for (const double* component : {outline.x, outline.y, outline.nx, outline.ny, outline.offset})
    to = std::copy_n(component, extent.vertices, to);
}

void copy_components(const Outline<3>& outline, double* to) {
  const Extent extent = extent_of(outline);
  for (const double* component : {outline.x, outline.y, outline.z})
    to = std::copy_n(component, extent.vertices, to);
  for (const double* component : {outline.nx, outline.ny, outline.nz, outline.offset})
    to = std::copy_n(component, extent.halfspaces, to);
}

}  // namespace

template <>
std::size_t Outlines<2>::length(std::int32_t form) const {
  return extent_of(form).length();
}

template <>
std::size_t Outlines<3>::length(std::int32_t form) const {
  return extent_of(topologies_[form]).length();
}

template <int D>
typename Outlines<D>::Taken Outlines<D>::take_in(const Outline<D>& outline) {
  const Extent extent = extent_of(outline);
  const std::size_t first = own_.size();
  Taken taken{std::int64_t(first), 0};
  try {
    own_.resize(first + extent.length());
    turned_.resize(first + extent.length());
    if constexpr (D == 2) {
      taken.form = outline.count;
    } else {
      taken.form = topologies_.add(*outline.topology);
    }
  } catch (...) {
    own_.resize(first);
    turned_.resize(first);
    throw;
  }
  copy_components(outline, own_.data() + first);
  std::copy_n(outline.offset, extent.halfspaces, turned_.data() + first + extent.offset());
  return taken;
}

template <>
Outlines<2>::Taken Outlines<2>::take_in(const OutlineCopy<2>& copy) {
  return take_in(outline_at(copy.vertices, copy.components.data()));
}

template <>
Outlines<3>::Taken Outlines<3>::take_in(const OutlineCopy<3>& copy) {
  const Topology topology = topology_at(copy.topology.data(), copy.vertices, copy.edges, copy.faces);
  return take_in(outline_at(topology, copy.components.data()));
}

template <>
void Outlines<2>::copy(std::int32_t slot, OutlineCopy<2>& to) const {
  const Outline<2> outline = own(slot);
  to.vertices = to.edges = to.faces = outline.count;
  to.components.assign(outline.x, outline.x + extent_of(outline).length());
}

template <>
void Outlines<3>::copy(std::int32_t slot, OutlineCopy<3>& to) const {
  const Outline<3> outline = own(slot);
  const Topology& topology = *outline.topology;
  to.vertices = topology.vertex_count;
  to.edges = topology.edge_count;
  to.faces = topology.face_count;
  to.components.assign(outline.x, outline.x + extent_of(outline).length());
  to.topology.assign(topology.first_of_face,
                     topology.first_of_face + topology_length(to.vertices, to.edges, to.faces));
}

template <>
bool Outlines<2>::is_sound(const OutlineCopy<2>&) const {
  return true;
}

template <>
bool Outlines<3>::is_sound(const OutlineCopy<3>& copy) const {
  return topologies_.is_sound(topology_at(copy.topology.data(), copy.vertices, copy.edges, copy.faces));
}

template <int D>
void Outlines<D>::begin_taking_over(const Outlines& other, std::size_t count) {
  first_.reserve(count);
  form_.reserve(count);
  const std::size_t components = other.own_.size() / std::max<std::size_t>(1, other.slot_count()) * count;
  own_.reserve(components);
  turned_.reserve(components);
  if constexpr (D == 3) topologies_.hold_all_of(other.topologies_);
}

template <int D>
typename Outlines<D>::Taken Outlines<D>::take_over(const Outlines& other, std::int32_t slot) {
  const Taken taken{std::int64_t(own_.size()), other.form_[std::size_t(slot)]};
  const auto append = [&](Array<double>& to, const Array<double>& from) {
    const auto first = from.begin() + other.first_[std::size_t(slot)];
    to.insert(to.end(), first, first + std::ptrdiff_t(other.length(taken.form)));
  };
  append(own_, other.own_);
  append(turned_, other.turned_);
  if constexpr (D == 3) topologies_.add_user(taken.form);
  return taken;
}

template <int D>
void Outlines<D>::end_taking_over() {
  if constexpr (D == 3) topologies_.end_holding();
}

template <int D>
typename Outlines<D>::Taken Outlines<D>::take_in_none() {
  Taken taken{std::int64_t(own_.size()), 0};
  if constexpr (D == 3) taken.form = topologies_.add(no_topology());
  return taken;
}

template <int D>
void Outlines<D>::assign(std::int32_t slot, const Taken& taken) {
  first_[std::size_t(slot)] = taken.first;
  form_[std::size_t(slot)] = taken.form;
}

template <int D>
void Outlines<D>::undo(const Taken& taken) {
  own_.resize(std::size_t(taken.first));
  turned_.resize(std::size_t(taken.first));
  if constexpr (D == 3) topologies_.release(taken.form);
}

template <int D>
void Outlines<D>::drop(std::int32_t slot) {
  const std::int64_t first = first_[std::size_t(slot)];
  const std::int64_t past = first + std::int64_t(length(form_[std::size_t(slot)]));
  own_.erase(own_.begin() + first, own_.begin() + past);
  turned_.erase(turned_.begin() + first, turned_.begin() + past);
  for (std::int64_t& other : first_) {
    if (other > first) other -= past - first;
  }
  if constexpr (D == 3) topologies_.release(form_[std::size_t(slot)]);
}

template <int D>
[[gnu::always_inline]] inline void Outlines<D>::map(std::int32_t slot, const Tensor<D>& vertices,
                                                    const Tensor<D>& normals) {
  const std::size_t s = std::size_t(slot);
  const Extent extent = extent_of((*this)[slot]);
  const double* own = own_.data() + first_[s];
  double* turned = turned_.data() + first_[s];
  const std::size_t to_normals = D * extent.vertices;
  map_vectors(vertices, own, extent.vertices, turned);
  map_vectors(normals, own + to_normals, extent.halfspaces, turned + to_normals);
}

template <int D>
void Outlines<D>::turn(std::int32_t slot, const Rotation<D>& rotation) {
  map(slot, rotation.tensor(), rotation.tensor());
}

template <int D>
void Outlines<D>::deform(std::int32_t slot, const Tensor<D>& gradient) {
  deformed(own(slot), gradient, turned_.data() + first_[std::size_t(slot)]);
}

template <>
bool Outlines<2>::is_form(std::int32_t form) const {
  return form == 0 || (form >= 3 && std::size_t(form) <= own_.size());
}

template <>
bool Outlines<3>::is_form(std::int32_t form) const {
  return topologies_.has(form);
}

template <>
bool Outlines<2>::counts_users(std::span<const std::int32_t>) const {
  return true;
}

/// A count that is too small would free a topology while blocks still use it.
template <>
bool Outlines<3>::counts_users(std::span<const std::int32_t> living) const {
  Array<std::int32_t> users(topologies_.size(), 0, form_.get_allocator());
  for (const std::int32_t slot : living) ++users[std::size_t(form_[std::size_t(slot)])];
  for (std::size_t i = 0; i < users.size(); ++i) {
    if (users[i] != topologies_.users(std::int32_t(i))) return false;
  }
  return true;
}

template <int D>
bool Outlines<D>::is_consistent(std::span<const std::int32_t> living) const {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  const auto are_finite = [&](const Array<double>& values) {
    return std::all_of(values.begin(), values.end(), is_finite);
  };
  if (form_.size() != first_.size() || own_.size() != turned_.size()) return false;
  if (!are_finite(own_) || !are_finite(turned_)) return false;
  if constexpr (D == 3) {
    if (!topologies_.is_consistent()) return false;
  }
  Array<Range> ranges(first_.get_allocator().resource());
  for (const std::int32_t slot : living) {
    const std::int32_t form = form_[std::size_t(slot)];
    if (!is_form(form)) return false;
    ranges.push_back({first_[std::size_t(slot)], std::int64_t(length(form))});
  }
  return fill_without_gap(ranges, own_.size()) && counts_users(living);
}

template class Outlines<2>;
template class Outlines<3>;

}  // namespace halfspace
