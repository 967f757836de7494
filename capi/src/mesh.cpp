#include <cstddef>

#include "block/mesh/make_element.h"
#include "mesh_handle.h"
#include "sized_struct.h"
#include "strided_view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// Nodes and cells have 32-bit indices.
constexpr int bits_of_nodes = 28;

/// Refuses a mesh. The text names the argument, the faulty cell and the faulty node with its position.
template <int D>
[[noreturn]] void refuse_mesh(const Mesh<D>& mesh, const MeshFaultReport& report,
                              std::span<const std::int32_t> kinds, std::size_t cell_node_count) {
  const char* const text = fault_text(report.fault);
  const auto cell = static_cast<long long>(report.cell), node = static_cast<long long>(report.node);
  switch (report.fault) {
    case MeshFault::no_cells:
      refuse(HS_ERROR_ARGUMENT, "cell_count is 0; it must be at least 1");
    case MeshFault::wrong_kind:
      refuse(HS_ERROR_ARGUMENT, "cell_kinds[%lld] is %d; it must be an HS_CELL_ value of dimension %d", cell,
             kinds[std::size_t(cell)], D);
    case MeshFault::wrong_count:
      refuse(HS_ERROR_ARGUMENT, "cell_node_count is %zu; cell_kinds need %s", cell_node_count,
             cell < 0 ? "fewer" : "more");
    case MeshFault::no_such_node:
      refuse(HS_ERROR_ARGUMENT, "cell %lld has node %lld; it must be below nodes.count, which is %zu", cell,
             node, mesh.nodes.size());
    case MeshFault::node_twice:
      refuse(HS_ERROR_GEOMETRY, "cell %lld has node %lld twice", cell, node);
    case MeshFault::out_of_range:
    case MeshFault::unused_node:
      refuse(report.fault == MeshFault::unused_node ? HS_ERROR_GEOMETRY : HS_ERROR_ARGUMENT,
             "nodes[%lld] = %s %s", node, PointText(mesh.nodes[std::size_t(report.node)]).characters, text);
    default:
      refuse(HS_ERROR_GEOMETRY, "cell %lld %s", cell, text);
  }
}

template <int D>
hs_mesh* create_mesh(hs_context* context, const hs_view& nodes, std::span<const std::int32_t> kinds,
                     std::span<const std::int32_t> cell_nodes) {
  Mesh<D> mesh(&context->memory);
  mesh.nodes = read_points<D>(context, nodes, "nodes");
  const MeshFaultReport report = make_mesh(kinds, cell_nodes, mesh);
  if (report.fault != MeshFault::none) refuse_mesh(mesh, report, kinds, cell_nodes.size());
  return create<MeshHandle<D>>(context, context, std::move(mesh));
}

template <int D>
double volume_of(const Mesh<D>& mesh) {
  double volume = 0;
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
    with_nodes(mesh, cell, [&]<int N>(const Eigen::Matrix<double, D, N>& nodes) {
      volume += volumes_of_nodes<D, N>(nodes).sum();
    });
  }
  return volume;
}

}  // namespace

hs_status hs_mesh_create(hs_context* context, int32_t dimension, hs_view nodes, const int32_t cell_kinds[],
                         int64_t cell_count, const int32_t cell_nodes[], int64_t cell_node_count,
                         hs_mesh** mesh) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(mesh, "mesh");
    if (dimension != 2 && dimension != 3)
      refuse(HS_ERROR_ARGUMENT, "dimension is %d; it must be 2 or 3", dimension);
    require_numbered(nodes.count, "nodes.count", bits_of_nodes);
    require_numbered(cell_count, "cell_count", bits_of_nodes);
    require_numbered(cell_node_count, "cell_node_count", bits_of_nodes);
    if (cell_count > 0) require_pointer(cell_kinds, "cell_kinds");
    if (cell_node_count > 0) require_pointer(cell_nodes, "cell_nodes");
    const std::span kinds(cell_kinds, std::size_t(cell_count));
    const std::span named(cell_nodes, std::size_t(cell_node_count));
    *mesh = dimension == 2 ? create_mesh<2>(context, nodes, kinds, named)
                           : create_mesh<3>(context, nodes, kinds, named);
    return HS_OK;
  });
}

void hs_mesh_destroy(hs_mesh* mesh) {
  if (!mesh) return;
  if (mesh->dimension == 2) {
    destroy(mesh->context, static_cast<MeshHandle<2>*>(mesh));
  } else {
    destroy(mesh->context, static_cast<MeshHandle<3>*>(mesh));
  }
}

hs_status hs_mesh_get_properties(const hs_mesh* mesh, hs_mesh_properties* properties, size_t size) {
  return guarded(context_of(mesh), __func__, [&] {
    require_pointer(mesh, "mesh");
    require_pointer(properties, "properties");
    require_report_size(size, sizeof(hs_mesh_properties));
    visit(*mesh, [&]<int D>(const Mesh<D>& m) {
      const hs_mesh_properties ours = {D,
                                       0,
                                       std::int64_t(m.nodes.size()),
                                       std::int64_t(m.cell_count()),
                                       mesh->surface_face_count,
                                       volume_of(m)};
      write_sized(ours, properties, size);
    });
    return HS_OK;
  });
}
