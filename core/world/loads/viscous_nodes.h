#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "block/mesh/meshes.h"

namespace halfspace {

/// Dashpots between nodes and the ground. On the nodes of a face with the impedance of its material they take
/// up the waves that reach it (Lysmer and Kuhlemeyer 1969).
template <int D>
class ViscousNodes {
 public:
  explicit ViscousNodes(Memory* memory) : nodes_(memory), of_node_(memory) {}

  bool empty() const { return nodes_.empty(); }
  /// Force over velocity of a node, N s/m; null without a dashpot.
  const Tensor<D>* viscosity_of(std::size_t node) const {
    return node < of_node_.size() && of_node_[node] >= 0 ? &nodes_[std::size_t(of_node_[node])].viscosity
                                                         : nullptr;
  }
  /// Sets the viscosity of nodes of a body; 0 removes their dashpots. If memory runs out, nothing has
  /// changed.
  void set(std::int32_t body, std::span<const std::int32_t> nodes, const Tensor<D>& viscosity,
           const Meshes<D>& meshes) {
    nodes_.reserve(nodes_.size() + nodes.size());
    of_node_.reserve(meshes.node_count());
    Array<std::int32_t> sorted(nodes.begin(), nodes.end(), nodes_.get_allocator());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    remove_if([&](const Node& known) {
      return known.body == body && std::binary_search(sorted.begin(), sorted.end(), std::int32_t(known.node));
    });
    if (!viscosity.isZero(0)) {
      for (const std::int32_t node : sorted) nodes_.push_back({body, node, viscosity});
    }
    renew(meshes);
  }
  void remove_body(std::int32_t body) {
    remove_if([&](const Node& known) { return known.body == body; });
  }
  /// Call when nodes have been renumbered, and after reading.
  void renew(const Meshes<D>& meshes) {
    of_node_.assign(nodes_.empty() ? 0 : meshes.node_count(), -1);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      of_node_[std::size_t(meshes.body(std::int32_t(nodes_[i].body)).first_node + nodes_[i].node)] =
          std::int32_t(i);
  }

  /// Validates the state read from a snapshot.
  bool is_consistent(const Meshes<D>& meshes) const {
    return all(nodes_, [&](const Node& node) {
      return node.body >= 0 && std::size_t(node.body) < meshes.bodies().size() && node.node >= 0 &&
             node.node < meshes.body(std::int32_t(node.body)).node_count && node.viscosity.allFinite();
    });
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(nodes_);
  }

 private:
  struct Node {
    std::int64_t body = -1;
    std::int64_t node = -1;  // of the body
    Tensor<D> viscosity = Tensor<D>::Zero();
  };

  template <class Condition>
  void remove_if(Condition condition) {
    nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), condition), nodes_.end());
  }

  Array<Node> nodes_;
  Array<std::int32_t> of_node_;  // per node of all bodies: its entry, or -1; empty without dashpots
};

}  // namespace halfspace
