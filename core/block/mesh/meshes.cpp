#include "block/mesh/meshes.h"

#include <algorithm>
#include <cmath>

#include "block/inertia.h"
#include "block/mesh/make_element.h"

namespace halfspace {
template <int D>
Meshes<D>::Meshes(Memory* memory)
    : place(memory),
      given(memory),
      velocity(memory),
      force(memory),
      applied_force(memory),
      mass(memory),
      held(memory),
      elements_(std::allocator_arg, std::pmr::polymorphic_allocator<std::byte>(memory)),
      bodies_(memory),
      surface_(memory),
      of_block_(memory) {}

/// The stiffest element limits the time step of the body.
template <int D>
template <int N>
void Meshes<D>::note_stiffness(const Element<D, N>& element, const Eigen::Matrix<double, N, 1>& masses,
                               const Elasticity& elasticity) {
  Body<D>& body = bodies_[std::size_t(element.body)];
  body.squared_frequency =
      std::max(body.squared_frequency, squared_frequency<D, N>(element, elasticity, masses));
  body.damping_time = std::max(body.damping_time, elasticity.damping_time);
}

template <int D>
template <int N>
void Meshes<D>::add_element(const std::array<std::int32_t, N>& nodes, std::int32_t body, std::size_t cell,
                            std::int32_t material, const BulkMaterials& materials) {
  const std::size_t m = std::size_t(material);
  const Eigen::Matrix<double, D, N> places = gathered<D, N>(given, nodes);
  Element<D, N> element = make_element<D, N>(places, materials.elasticity[m]);
  element.node = nodes;
  element.body = body;
  element.cell = std::int32_t(cell);
  element.material = material;
  const Eigen::Matrix<double, N, 1> masses = materials.density[m] * volumes_of_nodes<D, N>(places);
  for (int i = 0; i < N; ++i) mass[std::size_t(nodes[std::size_t(i)])] += masses[i];
  double& steepest = bodies_[std::size_t(body)].steepest;
  steepest = std::max(steepest, element.gradients.colwise().norm().sum());
  note_stiffness(element, masses, materials.elasticity[m]);
  elements_of<N>().push_back(element);
}

template <int D>
std::int32_t Meshes<D>::add(const Mesh<D>& mesh, const Pose<D>& pose,
                            std::span<const std::int32_t> cell_materials, const BulkMaterials& materials) {
  const std::size_t first = node_count(), nodes = first + mesh.nodes.size();
  const std::int32_t which = std::int32_t(bodies_.size());
  const Tensor<D> turn = pose.rotation.tensor();
  const Vector<D> middle = middle_of(mesh);
  Body<D> body;
  body.origin = pose.position + turn * middle;
  body.generation = 1;
  body.lives = 1;
  body.first_node = std::int64_t(first);
  body.node_count = std::int64_t(mesh.nodes.size());
  body.cell_count = std::int64_t(mesh.cell_count());
  ++edits_;
  bodies_.push_back(body);
  try {
    for (Array<Vector<D>>* vectors : {&velocity, &force, &applied_force})
      vectors->resize(nodes, Vector<D>::Zero());
    mass.resize(nodes, 0);
    held.resize(nodes, 0);
    for (const Vector<D>& node : mesh.nodes) given.push_back(turn * (node - middle));
    place.insert(place.end(), given.begin() + std::ptrdiff_t(first), given.end());
    for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
      with_nodes(mesh, cell, [&]<int N>(const Eigen::Matrix<double, D, N>&) {
        std::array<std::int32_t, N> named;
        for (std::size_t i = 0; i < N; ++i) named[i] = std::int32_t(first) + mesh.nodes_of(cell)[i];
        add_element<N>(named, which, cell, cell_materials[cell], materials);
      });
    }
  } catch (...) {
    take_back();
    throw;
  }
  return which;
}

template <int D>
void Meshes<D>::take_back() {
  remove(std::int32_t(bodies_.size()) - 1);
  bodies_.pop_back();
}

template <int D>
MeshFaultReport Meshes<D>::fault_of(std::int32_t which) const {
  const auto is_bounded = [&](std::int32_t node) {
    return mass[std::size_t(node)] >= min_mass && mass[std::size_t(node)] <= largest_mass;
  };
  MeshFaultReport report;
  for_each_element_of(which, [&](const auto& element) {
    if (report.cell >= 0 && report.cell < element.cell) return;
    if (!is_positive(element.volume)) {
      report = {MeshFault::inside_out, element.cell};
    } else if (!element.is_finite() || !all(element.node, is_bounded)) {
      report = {MeshFault::beyond_bounds, element.cell};
    }
  });
  if (report.fault == MeshFault::none && !is_finite(body(which).squared_frequency))
    return {MeshFault::beyond_bounds};
  return report;
}

template <int D>
void Meshes<D>::remove(std::int32_t which) {
  Body<D>& gone = bodies_[std::size_t(which)];
  const std::int64_t first = gone.first_node, count = gone.node_count;
  ++edits_;
  const auto is_gone = [&](const auto& part) { return part.body == which; };
  const auto renumber = [&](auto& part) {
    for (std::int32_t& node : part.node) {
      if (node >= first + count) node -= std::int32_t(count);
    }
  };
  std::apply([&](auto&... kind) { (std::erase_if(kind, is_gone), ...); }, elements_);
  std::erase_if(surface_, is_gone);
  for_each_element(renumber);
  std::for_each(surface_.begin(), surface_.end(), renumber);
  index_surface();
  const auto close_gap = [&](auto& array) {
    const std::size_t begin = std::min(std::size_t(first), array.size());
    const std::size_t end = std::min(std::size_t(first + count), array.size());
    array.erase(array.begin() + std::ptrdiff_t(begin), array.begin() + std::ptrdiff_t(end));
  };
  for (Array<Vector<D>>* vectors : {&place, &given, &velocity, &force, &applied_force}) close_gap(*vectors);
  close_gap(mass);
  close_gap(held);
  for (Body<D>& body : bodies_) {
    if (body.first_node > first) body.first_node -= count;
  }
  gone.lives = 0;
  gone.node_count = gone.cell_count = 0;
  gone.squared_frequency = gone.steepest = 0;
}

template <int D>
void Meshes<D>::index_surface() {
  std::fill(of_block_.begin(), of_block_.end(), -1);
  for (std::size_t i = 0; i < surface_.size(); ++i)
    of_block_[std::size_t(surface_[i].block)] = std::int32_t(i);
  while (!of_block_.empty() && of_block_.back() < 0) of_block_.pop_back();
}

template <int D>
void Meshes<D>::take_back_surface(std::size_t from, std::int32_t which, double steepest) {
  surface_.resize(from);
  index_surface();
  bodies_[std::size_t(which)].steepest = steepest;
}

template <int D>
void Meshes<D>::remove_cells(std::int32_t which, const Array<std::uint8_t>& is_gone,
                             const BulkMaterials& materials) {
  const auto goes = [&](const auto& part) { return part.body == which && is_gone[std::size_t(part.cell)]; };
  ++edits_;
  std::apply([&](auto&... kind) { (std::erase_if(kind, goes), ...); }, elements_);
  std::erase_if(surface_, goes);
  std::sort(surface_.begin(), surface_.end(), [](const SurfaceCell<D>& a, const SurfaceCell<D>& b) {
    return std::tie(a.body, a.cell, a.node) < std::tie(b.body, b.cell, b.node);
  });
  index_surface();
  const std::size_t first = std::size_t(body(which).first_node);
  const std::size_t last = first + std::size_t(body(which).node_count);
  std::fill(mass.begin() + std::ptrdiff_t(first), mass.begin() + std::ptrdiff_t(last), 0.0);
  for_each_element_of(which, [&]<int N>(const Element<D, N>& element) {
    const Eigen::Matrix<double, N, 1> volumes = volumes_of_nodes<D, N>(gathered<D, N>(given, element.node));
    for (int i = 0; i < N; ++i)
      mass[std::size_t(element.node[std::size_t(i)])] +=
          materials.density[std::size_t(element.material)] * volumes[i];
  });
  for (std::size_t i = first; i < last; ++i) {
    if (mass[i] > 0) continue;
    velocity[i] = force[i] = applied_force[i] = Vector<D>::Zero();
    held[i] = held_along_all<D>;
  }
}

template <int D>
void Meshes<D>::renew_elasticity(const BulkMaterials& materials) {
  for (Body<D>& body : bodies_) body.squared_frequency = body.damping_time = 0;
  for_each_element([&]<int N>(Element<D, N>& element) {
    const std::size_t m = std::size_t(element.material);
    const Eigen::Matrix<double, D, N> places = gathered<D, N>(given, element.node);
    element.hourglass = make_element<D, N>(places, materials.elasticity[m]).hourglass;
    note_stiffness<N>(element, materials.density[m] * volumes_of_nodes<D, N>(places),
                      materials.elasticity[m]);
  });
}

template <int D>
std::int32_t Meshes<D>::stiffest_cell_of(std::int32_t which, const BulkMaterials& materials) const {
  std::int32_t stiffest = -1;
  double most = -1;
  for_each_element_of(which, [&]<int N>(const Element<D, N>& element) {
    const std::size_t m = std::size_t(element.material);
    const Eigen::Matrix<double, N, 1> masses =
        materials.density[m] * volumes_of_nodes<D, N>(gathered<D, N>(given, element.node));
    const double squared = squared_frequency<D, N>(element, materials.elasticity[m], masses);
    if (squared <= most) return;
    most = squared;
    stiffest = element.cell;
  });
  return stiffest;
}

template <int D>
bool Meshes<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t nodes = node_count();
  const auto is_finite_vector = [](const Vector<D>& v) { return all_finite(v); };
  for (const Array<Vector<D>>* vectors : {&place, &given, &velocity, &applied_force}) {
    if (vectors->size() != nodes || !all(*vectors, is_finite_vector)) return false;
  }
  if (force.size() != nodes) return false;  // not finite: the next step reports it, as for blocks
  if (mass.size() != nodes || held.size() != nodes || !all(mass, is_nonnegative)) return false;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (mass[i] == 0 && held[i] != held_along_all<D>) return false;
  }
  std::int64_t counted = 0;
  for (const Body<D>& body : bodies_) {
    const std::int64_t left = std::int64_t(nodes) - counted;
    if (body.first_node != counted || body.node_count < 0 || body.node_count > left) return false;
    // D nodes identify a face, and a face has at most two cells, each with more than two faces.
    if (body.cell_count < 0 || double(body.cell_count) > std::pow(double(body.node_count), D)) return false;
    if (body.lives != 0 && body.lives != 1) return false;
    if (!all_finite(body.origin) || !(body.squared_frequency >= 0) || !is_nonnegative(body.damping_time) ||
        !is_nonnegative(body.steepest))
      return false;
    counted += body.node_count;
  }
  if (std::size_t(counted) != nodes) return false;
  const auto has_own_nodes = [&](const auto& part) {
    if (part.body < 0 || std::size_t(part.body) >= bodies_.size()) return false;
    const Body<D>& of = body(part.body);
    return of.lives && all(part.node, [&](std::int32_t node) {
             return node >= of.first_node && node < of.first_node + of.node_count;
           });
  };
  const auto precedes = [](const auto& a, const auto& b) { return a.body < b.body; };
  bool fits = std::is_sorted(surface_.begin(), surface_.end(), precedes);
  std::apply(
      [&](const auto&... kind) {
        ((fits = fits && std::is_sorted(kind.begin(), kind.end(), precedes)), ...);
      },
      elements_);
  for_each_element([&](const auto& element) {
    fits = fits && element.is_consistent(nodes, material_count) && has_own_nodes(element) &&
           element.cell < body(element.body).cell_count;
  });
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    const SurfaceCell<D>& cell = surface_[i];
    fits = fits && cell.block >= 0 && std::size_t(cell.block) < of_block_.size() &&
           of_block_[std::size_t(cell.block)] == std::int32_t(i) && all_finite(cell.gradients) &&
           cell.outer_faces >= 0 && cell.outer_faces < 1 << (D + 1) && has_own_nodes(cell) &&
           cell.cell >= 0 && cell.cell < body(cell.body).cell_count;
  }
  return fits;
}

template class Meshes<2>;
template class Meshes<3>;

}  // namespace halfspace
