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

/// The elements of a world, one array per number of nodes.
template <int D>
using Elements =
    std::conditional_t<D == 2, std::tuple<Array<Element<2, 3>>, Array<Element<2, 4>>>,
                       std::tuple<Array<Element<3, 4>>, Array<Element<3, 6>>, Array<Element<3, 8>>>>;

/// The properties of a world's materials.
struct BulkMaterials {
  std::span<const double> density;
  std::span<const Elasticity> elasticity;
};

/// A mesh in a world.
template <int D>
struct Body {
  Vector<D> origin =
      Vector<D>::Zero();  // of its nodes' coordinates: strains stay accurate far from the world's origin
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

/// The value of `held` of a node that is held along all axes.
template <int D>
inline constexpr std::uint8_t held_along_all = (1 << D) - 1;

/// A simplex at the surface of a body: a block that makes contact for the body and is moved by its nodes.
template <int D>
struct SurfaceCell {
  std::int32_t block = -1;  // slot
  std::int32_t body = 0;
  std::int32_t cell = 0;         // index in the mesh of the body
  std::int32_t outer_faces = 0;  // bit k: the face opposite to node k is at the surface
  std::array<std::int32_t, D + 1> node{};
  std::array<std::int32_t, D == 2 ? 1 : 4> padding{};
  Eigen::Matrix<double, D, D + 1> gradients =  // of its nodes' interpolation, in the frame of its shape
      Eigen::Matrix<double, D, D + 1>::Zero();

  /// The mean of a nodal field over its nodes, and the gradient of the field.
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

/// A cell that has become inverted.
struct InvertedCell {
  std::int32_t body = -1;  // none
  std::int32_t cell = -1;
};

/// The bodies of finite elements in a world: nodes shared by elements, as a structure of arrays. Empty in
/// worlds without meshes.
template <int D>
class Meshes {
 public:
  explicit Meshes(Memory* memory);

  bool empty() const { return place.empty(); }
  std::size_t node_count() const { return place.size(); }
  const Array<Body<D>>& bodies() const { return bodies_; }
  const Body<D>& body(std::int32_t body) const { return bodies_[std::size_t(body)]; }
  const Array<SurfaceCell<D>>& surface() const { return surface_; }

  /// Adds nodes and elements of a mesh, at a pose of its frame, with one material per cell, without its
  /// surface. Returns the index of the body.
  std::int32_t add(const Mesh<D>& mesh, const Pose<D>& pose, std::span<const std::int32_t> cell_materials,
                   const BulkMaterials& materials);
  /// Allocates for so many more surface cells, after the present slots.
  void make_room_on_surface(std::size_t cells, std::size_t slots) {
    const auto make_room = [](auto& array, std::size_t count) {
      if (array.capacity() < count) array.reserve(std::max(count, 2 * array.capacity()));
    };
    make_room(surface_, surface_.size() + cells);
    make_room(of_block_, slots + cells);
  }
  /// Adds a block that is a cell of the surface.
  void add_to_surface(const SurfaceCell<D>& cell) {
    const std::size_t slot = std::size_t(cell.block);
    double& steepest = bodies_[std::size_t(cell.body)].steepest;
    steepest = std::max(steepest, cell.gradients.colwise().norm().sum());
    surface_.push_back(cell);
    if (of_block_.size() <= slot) of_block_.resize(slot + 1, -1);
    of_block_[slot] = std::int32_t(surface_.size()) - 1;
  }
  /// Undoes the last add().
  void take_back();
  /// The cell of a body's stiffest element, which limits the time step; -1 without elements.
  std::int32_t stiffest_cell_of(std::int32_t body, const BulkMaterials& materials) const;
  /// The first fault of a body's elements, if any.
  MeshFaultReport fault_of(std::int32_t body) const;
  /// Removes a body with its nodes, elements and surface. Indices of other bodies stay.
  void remove(std::int32_t body);
  /// Removes the cells with is_gone[cell] and their surface, and updates the masses of nodes. A node without
  /// cells stays in place.
  void remove_cells(std::int32_t body, const Array<std::uint8_t>& is_gone, const BulkMaterials& materials);
  /// Removes the surface cells of a body from this index on; their blocks have been removed before.
  /// `steepest`: of the body without them.
  void take_back_surface(std::size_t from, std::int32_t body, double steepest);
  /// Updates what elements have computed from their materials.
  void renew_elasticity(const BulkMaterials& materials);

  /// Grows when elements are added or removed. Not saved.
  std::int64_t edits() const { return edits_; }

  /// Calls visit(elements) for the array of each kind, in order.
  template <class Visit>
  void for_each_kind(Visit visit) const {
    std::apply([&](const auto&... kind) { (visit(kind), ...); }, elements_);
  }
  /// Calls visit(element) for all elements, in order.
  template <class Visit>
  void for_each_element(Visit&& visit) {
    std::apply([&](auto&... kind) { (visit_all(kind, visit), ...); }, elements_);
  }
  template <class Visit>
  void for_each_element(Visit&& visit) const {
    std::apply([&](const auto&... kind) { (visit_all(kind, visit), ...); }, elements_);
  }

  /// The same for the elements of a body, which are contiguous in the array of each kind.
  template <class Visit>
  void for_each_element_of(std::int32_t body, Visit&& visit) {
    std::apply([&](auto&... kind) { (visit_body(kind, body, visit), ...); }, elements_);
  }
  template <class Visit>
  void for_each_element_of(std::int32_t body, Visit&& visit) const {
    std::apply([&](const auto&... kind) { (visit_body(kind, body, visit), ...); }, elements_);
  }
  std::span<const SurfaceCell<D>> surface_of(std::int32_t body) const {
    const auto [first, last] = range_of(surface_, body);
    return {first, last};
  }

  /// The parts of a surface cell in the masses of its nodes: `bearing` is the number of surface cells per
  /// node of the body.
  Eigen::Matrix<double, D + 1, 1> masses_of(const SurfaceCell<D>& cell, const Array<int>& bearing) const {
    Eigen::Matrix<double, D + 1, 1> masses;
    for (std::size_t i = 0; i <= D; ++i) {
      const std::size_t node = std::size_t(cell.node[i]);
      masses[Eigen::Index(i)] = mass[node] / bearing[node - std::size_t(body(cell.body).first_node)];
    }
    return masses;
  }

  /// The surface cell of a block.
  const SurfaceCell<D>& surface_of_block(std::size_t slot) const {
    return surface_[std::size_t(of_block_[slot])];
  }
  /// Do two surface cells have a common node? They are then never in contact.
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

  /// The state that the evaluation of forces changes.
  auto state() { return std::tie(force); }

  Array<Vector<D>> place;  // from the origin of its body
  Array<Vector<D>> given;  // undeformed place, the reference of strains
  Array<Vector<D>> velocity;
  Array<Vector<D>> force;  // sum, before damping
  Array<Vector<D>> applied_force;
  Array<double> mass;
  Array<std::uint8_t> held;  // bit k: component k of the velocity is prescribed

 private:
  template <class Kind, class Visit>
  static void visit_all(Kind& kind, Visit& visit) {
    for (auto& element : kind) visit(element);
  }
  /// Rebuilds of_block_ after surface cells have changed.
  void index_surface();
  /// The elements of one body in an array sorted by body.
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
  std::int64_t edits_ = 0;
  Array<Body<D>> bodies_;
  Array<SurfaceCell<D>> surface_;  // sorted by body, then by cell
  Array<std::int32_t> of_block_;   // index in surface_, or -1; ends at the last surface block
};

extern template class Meshes<2>;
extern template class Meshes<3>;

}  // namespace halfspace
