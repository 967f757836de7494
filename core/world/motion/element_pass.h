#pragma once

#include "block/mesh/meshes.h"
#include "threads/threads.h"
#include "world/model/model.h"
#include "world/motion/velocity_change.h"

namespace halfspace {

/// The energy or power of an element, and its strain. Of several elements: the sum, and the largest strain.
struct ElementSums {
  double amount = 0;
  double squared_strain = 0;

  void add(const ElementSums& other) {
    amount += other.amount;
    squared_strain = std::max(squared_strain, other.squared_strain);
  }
};

/// Elements, surface cells and nodes that a worker processes at a time.
constexpr std::size_t cells_per_chunk = 64, nodes_per_chunk = 256;

/// Computes the forces of elements on nodes. On several threads each element writes its own forces; then each
/// node adds up those of its elements, in ascending order, as one thread does. So the sums have the same bits
/// for any number of threads.
template <int D>
class ElementPass {
 public:
  ElementPass(Model<D>& model, Threads* threads, Memory* memory)
      : model_(model),
        meshes_(model.blocks.meshes()),
        threads_(threads),
        forces_(memory),
        each_(memory),
        by_node_(memory),
        first_of_node_(memory) {}

  /// Adds the forces of all elements to those of their nodes. Returns the strain energy and the largest
  /// strain.
  ElementSums load_nodes();
  /// Power of the viscous stress, which was computed with the velocities `earlier_by` seconds before, without
  /// kicks.
  double damping_power(double earlier_by, const Array<Vector<D>>& acceleration,
                       const VelocityChange<D>* kicks);

  /// Takes the memory of several threads. Call it after elements have been added or removed.
  void fit_room();

 private:
  bool is_shared() const { return worker_count(threads_) > 1; }
  template <class OfElement>
  ElementSums sum_over_elements(OfElement of_element);
  void index_forces();
  void gather();

  Model<D>& model_;
  Meshes<D>& meshes_;
  Threads* threads_;
  // These arrays are empty in a world of one thread.
  Array<Vector<D>> forces_;             // of all elements on each of their nodes
  Array<ElementSums> each_;             // per element
  Array<std::uint32_t> by_node_;        // indices of forces, by node, ascending
  Array<std::uint32_t> first_of_node_;  // one more than nodes
  std::int64_t edits_ = -1;             // of the elements that are indexed
};

extern template class ElementPass<2>;
extern template class ElementPass<3>;

}  // namespace halfspace
