#include "world/motion/element_pass.h"

#include <algorithm>

namespace halfspace {

/// Calls of_element(element, index of its first force) for all elements, and sums up in their order.
template <int D>
template <class OfElement>
ElementSums ElementPass<D>::sum_over_elements(OfElement of_element) {
  ElementSums all;
  std::size_t first_element = 0, first_force = 0;
  meshes_.for_each_kind([&]<int N>(const Array<Element<D, N>>& elements) {
    if (!is_shared()) {
      for (const Element<D, N>& element : elements) all.add(of_element(element, 0));
      return;
    }
    for_each_chunk(threads_, elements.size(), cells_per_chunk, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i)
        each_[first_element + i] = of_element(elements[i], first_force + i * N);
    });
    first_element += elements.size();
    first_force += elements.size() * N;
  });
  for (const ElementSums& one : each_) all.add(one);
  return all;
}

template <int D>
ElementSums ElementPass<D>::load_nodes() {
  const ElementSums sums = sum_over_elements([&]<int N>(const Element<D, N>& element, std::size_t first) {
    using E = Element<D, N>;
    const Elasticity& elasticity = model_.materials.elasticity(element.material);
    const typename E::Field place = element.field_of(gathered<D, N>(meshes_.place, element.node));
    const Tensor<D> strain = E::strain_of(place);
    const typename E::Amplitudes bending = E::bending_of(place);
    Tensor<D> driving_strain = element.stressing_strain(strain);
    typename E::Amplitudes driving_bending = bending;
    if (elasticity.damping_time > 0) {
      const typename E::Field rate = element.field_of(gathered<D, N>(meshes_.velocity, element.node));
      driving_strain += elasticity.damping_time * E::strain_rate_of(place, rate);
      driving_bending += elasticity.damping_time * E::bending_rate_of(place, rate);
    }
    const typename E::Nodes forces =
        element.forces(place, elasticity.stress<D>(driving_strain), element.drive(driving_bending));
    for (std::size_t i = 0; i < N; ++i) {
      if (is_shared()) {
        forces_[first + i] = forces.col(Eigen::Index(i));
      } else {
        meshes_.force[std::size_t(element.node[i])] += forces.col(Eigen::Index(i));
      }
    }
    return ElementSums{element.strain_energy(strain, bending, elasticity), strain.squaredNorm()};
  });
  if (is_shared()) gather();
  return sums;
}

template <int D>
void ElementPass<D>::gather() {
  for_each_chunk(threads_, meshes_.node_count(), nodes_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t node = chunk.begin; node < chunk.end; ++node) {
      for (std::size_t i = first_of_node_[node]; i < first_of_node_[node + 1]; ++i)
        meshes_.force[node] += forces_[by_node_[i]];
    }
  });
}

template <int D>
double ElementPass<D>::damping_power(double earlier_by, const Array<Vector<D>>& acceleration,
                                     const VelocityChange<D>* kicks) {
  const auto power_of = [&]<int N>(const Element<D, N>& element, std::size_t) {
    using E = Element<D, N>;
    const Elasticity& elasticity = model_.materials.elasticity(element.material);
    if (elasticity.damping_time == 0) return ElementSums();
    const typename E::Field place = element.field_of(gathered<D, N>(meshes_.place, element.node));
    const typename E::Nodes velocity = gathered<D, N>(meshes_.velocity, element.node);
    const typename E::Field now = element.field_of(velocity);
    typename E::Nodes before = velocity - earlier_by * gathered<D, N>(acceleration, element.node);
    if (kicks) {
      for (int i = 0; i < N; ++i) before.col(i) -= kicks->of_node(std::size_t(element.node[std::size_t(i)]));
    }
    const typename E::Field earlier = element.field_of(before);
    const Tensor<D> stress = elasticity.stress<D>(E::strain_rate_of(place, earlier));
    double rate = element.volume * stress.cwiseProduct(E::strain_rate_of(place, now)).sum();
    if constexpr (E::modes > 0)
      rate += element.drive(E::bending_rate_of(place, earlier)).dot(E::bending_rate_of(place, now));
    return ElementSums{elasticity.damping_time * rate};
  };
  return sum_over_elements(power_of).amount;
}

template <int D>
void ElementPass<D>::fit_room() {
  if (!is_shared() || edits_ == meshes_.edits()) return;
  std::size_t elements = 0, forces = 0;
  meshes_.for_each_kind([&]<int N>(const Array<Element<D, N>>& kind) {
    elements += kind.size();
    forces += kind.size() * N;
  });
  each_.resize(elements);
  forces_.resize(forces);
  by_node_.resize(forces);
  first_of_node_.resize(meshes_.node_count() + 1);
  index_forces();
  edits_ = meshes_.edits();
}

/// A counting sort by node: forces on the same node stay in their order.
template <int D>
void ElementPass<D>::index_forces() {
  std::fill(first_of_node_.begin(), first_of_node_.end(), 0u);
  meshes_.for_each_element([&](const auto& element) {
    for (const std::int32_t node : element.node) ++first_of_node_[std::size_t(node) + 1];
  });
  for (std::size_t i = 1; i < first_of_node_.size(); ++i) first_of_node_[i] += first_of_node_[i - 1];
  std::uint32_t force = 0;
  meshes_.for_each_element([&](const auto& element) {
    for (const std::int32_t node : element.node) by_node_[first_of_node_[std::size_t(node)]++] = force++;
  });
  // The start of each node has moved to its end, which is the start of the next.
  std::copy_backward(first_of_node_.begin(), first_of_node_.end() - 1, first_of_node_.end());
  first_of_node_.front() = 0;
}

template class ElementPass<2>;
template class ElementPass<3>;

}  // namespace halfspace
