#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "block/mesh/element.h"
#include "block/mesh/mesh.h"
#include "geometry/pose.h"

namespace halfspace {

/// The elements of a world, those of each number of nodes side by side.
template <int D>
using Elements =
    std::conditional_t<D == 2, std::tuple<Array<Element<2, 3>>, Array<Element<2, 4>>>,
                       std::tuple<Array<Element<3, 4>>, Array<Element<3, 6>>, Array<Element<3, 8>>>>;

/// The properties of a world's materials.
struct BulkMaterials {
  std::span<const double> density;
  std::span<const Elasticity> elasticity;
};

/// A mesh that was put into a world.
template <int D>
struct Body {
  Vector<D> origin =
      Vector<D>::Zero();  // that nodes are seen from, so that a far place costs strains nothing
  std::uint32_t generation = 0;
  std::int32_t lives = 0;
  std::int64_t first_node = 0;
  std::int64_t node_count = 0;
  std::int64_t cell_count = 0;
  double squared_frequency = 0;  // of the stiffest element
  double damping_time = 0;       // the longest of its materials
  double steepest = 0;           // the largest sum of |gradients| of an element's nodes
  double reserved = 0;
};

/// The bits `held` of a node that is held along all axes.
template <int D>
inline constexpr std::uint8_t held_along_all = (1 << D) - 1;

/// A simplex at the surface of a body. It is a block, by which the body meets others; its nodes move it.
template <int D>
struct SurfaceCell {
  std::int32_t block = -1;  // slot
  std::int32_t body = 0;
  std::int32_t cell = 0;         // of the body's mesh
  std::int32_t outer_faces = 0;  // bit k: the face opposite to node k is at the surface
  std::array<std::int32_t, D + 1> node{};
  std::array<std::int32_t, D == 2 ? 1 : 4> padding{};
  Eigen::Matrix<double, D, D + 1> gradients =  // of its nodes' interpolation, in its shape's frame
      Eigen::Matrix<double, D, D + 1>::Zero();

  /// The mean of what its nodes have, and the gradient.
  Vector<D> mean_of(const Array<Vector<D>>& of_nodes) const {
    Vector<D> sum = Vector<D>::Zero();
    for (const std::int32_t i : node) sum += of_nodes[std::size_t(i)];
    return sum / (D + 1);
  }
  Tensor<D> gradient_of(const Array<Vector<D>>& of_nodes) const {
    Tensor<D> sum = Tensor<D>::Zero();
    for (int i = 0; i <= D; ++i)
      sum += of_nodes[std::size_t(node[std::size_t(i)])] * gradients.col(i).transpose();
    return sum;
  }
};

/// A cell that has been turned inside out.
struct InvertedCell {
  std::int32_t body = -1;  // none
  std::int32_t cell = -1;
};

/// The bodies of finite elements in a world: nodes that elements share, a component to an array. A world
/// without any has none of it.
template <int D>
class Meshes {
 public:
  explicit Meshes(Memory* memory);

  bool empty() const { return place.empty(); }
  std::size_t node_count() const { return place.size(); }
  const Array<Body<D>>& bodies() const { return bodies_; }
  const Body<D>& body(std::int32_t body) const { return bodies_[std::size_t(body)]; }
  const Array<SurfaceCell<D>>& surface() const { return surface_; }

  /// Takes a mesh in, at a pose of its own frame, with a material for each cell: nodes and elements, no
  /// surface yet. Returns the body.
  std::int32_t add(const Mesh<D>& mesh, const Pose<D>& pose, std::span<const std::int32_t> cell_materials,
                   const BulkMaterials& materials);
  /// Takes the memory for so many cells of the surface more, when there are so many slots.
  void make_room_on_surface(std::size_t cells, std::size_t slots) {
    const auto make_room = [](auto& array, std::size_t count) {
      if (array.capacity() < count) array.reserve(std::max(count, 2 * array.capacity()));
    };
    make_room(surface_, surface_.size() + cells);
    make_room(of_block_, slots + cells);
  }
  /// Takes a block in that is a cell of the surface.
  void add_to_surface(const SurfaceCell<D>& cell) {
    const std::size_t slot = std::size_t(cell.block);
    double& steepest = bodies_[std::size_t(cell.body)].steepest;
    steepest = std::max(steepest, cell.gradients.colwise().norm().sum());
    surface_.push_back(cell);
    if (of_block_.size() <= slot) of_block_.resize(slot + 1, -1);
    of_block_[slot] = std::int32_t(surface_.size()) - 1;
  }
  /// Takes the body back that was added last, as if it had never been.
  void take_back();
  /// The cell of a body's stiffest element, which sets the step of all; -1 without any.
  std::int32_t stiffest_cell_of(std::int32_t body, const BulkMaterials& materials) const;
  /// The fault that keeps a body's elements from being computed with.
  MeshFaultReport fault_of(std::int32_t body) const;
  /// Takes a body out with its nodes, elements and surface. The others keep their names.
  void remove(std::int32_t body);
  /// Takes cells out for which is_gone[cell] is true, with their surface, and gives nodes the mass of what is
  /// left. A node without any stays where it is.
  void remove_cells(std::int32_t body, const Array<std::uint8_t>& is_gone, const BulkMaterials& materials);
  /// Forgets the last cells of the surface, from the number of them on; their blocks have been taken back.
  void take_back_surface(std::size_t from);
  /// Works out anew what elements know of their materials.
  void renew_elasticity(const BulkMaterials& materials);

  /// Calls visit(element) for all elements, in their order.
  template <class Visit>
  void for_each_element(Visit&& visit) {
    std::apply([&](auto&... kind) { (visit_all(kind, visit), ...); }, elements_);
  }
  template <class Visit>
  void for_each_element(Visit&& visit) const {
    std::apply([&](const auto&... kind) { (visit_all(kind, visit), ...); }, elements_);
  }

  /// The same for the elements of a body, which stand side by side in each kind's array.
  template <class Visit>
  void for_each_element_of(std::int32_t body, Visit&& visit) {
    std::apply([&](auto&... kind) { (visit_body(kind, body, visit), ...); }, elements_);
  }
  template <class Visit>
  void for_each_element_of(std::int32_t body, Visit&& visit) const {
    std::apply([&](const auto&... kind) { (visit_body(kind, body, visit), ...); }, elements_);
  }
  /// The surface cells of a body.
  std::span<const SurfaceCell<D>> surface_of(std::int32_t body) const {
    const auto [first, last] = range_of(surface_, body);
    return {first, last};
  }

  /// The masses of a surface cell's nodes, as far as they are its own: `bearing` says how many cells each
  /// node of the body bears.
  Eigen::Matrix<double, D + 1, 1> masses_of(const SurfaceCell<D>& cell, const Array<int>& bearing) const {
    Eigen::Matrix<double, D + 1, 1> masses;
    for (std::size_t i = 0; i <= D; ++i) {
      const std::size_t node = std::size_t(cell.node[i]);
      masses[Eigen::Index(i)] = mass[node] / bearing[node - std::size_t(body(cell.body).first_node)];
    }
    return masses;
  }

  /// The surface cell that a block is.
  const SurfaceCell<D>& surface_of_block(std::size_t slot) const {
    return surface_[std::size_t(of_block_[slot])];
  }
  /// Two surface cells that a node joins, which never touch each other.
  bool are_joined(std::size_t a, std::size_t b) const {
    for (const std::int32_t i : surface_of_block(a).node) {
      for (const std::int32_t k : surface_of_block(b).node) {
        if (i == k) return true;
      }
    }
    return false;
  }

  bool is_consistent(std::int32_t material_count) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(place, given, velocity, force, applied_force, mass, held, bodies_, surface_, of_block_);
    std::apply([&](auto&... kind) { (archive(kind), ...); }, elements_);
  }

  /// All that forces write to.
  auto state() { return std::tie(force); }

  Array<Vector<D>> place;  // from its body's origin
  Array<Vector<D>> given;  // the place that strains are measured from
  Array<Vector<D>> velocity;
  Array<Vector<D>> force;  // all, before damping
  Array<Vector<D>> applied_force;
  Array<double> mass;
  Array<std::uint8_t> held;  // bit k: component k of the velocity is prescribed

 private:
  template <class Kind, class Visit>
  static void visit_all(Kind& kind, Visit& visit) {
    for (auto& element : kind) visit(element);
  }
  /// Where surface cells are, after they have changed.
  void index_surface();
  /// The part of an array in ascending order of bodies that belongs to one of them.
  template <class Parts>
  static auto range_of(Parts& parts, std::int32_t body) {
    const auto first = std::partition_point(parts.begin(), parts.end(),
                                            [body](const auto& part) { return part.body < body; });
    const auto last =
        std::partition_point(first, parts.end(), [body](const auto& part) { return part.body == body; });
    return std::pair(first, last);
  }
  template <class Kind, class Visit>
  static void visit_body(Kind& kind, std::int32_t body, Visit& visit) {
    const auto [first, last] = range_of(kind, body);
    for (auto element = first; element != last; ++element) visit(*element);
  }
  template <int N>
  Array<Element<D, N>>& elements_of() {
    return std::get<Array<Element<D, N>>>(elements_);
  }
  template <int N>
  void add_element(const std::array<std::int32_t, N>& nodes, std::int32_t body, std::size_t cell,
                   std::int32_t material, const BulkMaterials& materials);
  template <int N>
  void note_stiffness(const Element<D, N>& element, const Eigen::Matrix<double, N, 1>& masses,
                      const Elasticity& elasticity);

  Elements<D> elements_;
  Array<Body<D>> bodies_;
  Array<SurfaceCell<D>> surface_;  // in ascending order of bodies, then of cells
  Array<std::int32_t> of_block_;   // where in surface_, or -1; short of the slots after the last
};

extern template class Meshes<2>;
extern template class Meshes<3>;

}  // namespace halfspace
