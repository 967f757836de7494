#include <cstddef>

#include "geometry/polygon/check.h"
#include "geometry/polyhedron/check.h"
#include "shape_faults.h"
#include "shape_handle.h"
#include "strided_view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// Memory for the duration of a call: on the stack for shapes of usual size, else from the context.
class TemporaryMemory {
 public:
  explicit TemporaryMemory(Memory* upstream) : memory_(buffer_, sizeof buffer_, upstream) {}
  Memory* get() { return &memory_; }

 private:
  alignas(std::max_align_t) std::byte buffer_[16384];
  std::pmr::monotonic_buffer_resource memory_;
};

void set_vertices(Shape<2>& shape, const hs_view& view, Memory* memory) {
  Array<Vector<2>> vertices = read_points<2>(memory, view, "vertices");
  const FaultReport report = check_polygon(vertices);
  if (report.fault != Fault::none) refuse_polygon(report, "vertices", vertices);
  shape.set_vertices(vertices);
}

void set_vertices(Shape<3>& shape, const hs_view& view, Memory* memory) {
  const Topology& topology = shape.topology();
  Polyhedron moved(memory);
  moved.vertices = read_points<3>(memory, view, "vertices");
  moved.first_of_face.assign(topology.first_of_face, topology.first_of_face + topology.face_count + 1);
  moved.face_vertices.assign(topology.face_vertex, topology.face_vertex + 2 * topology.edge_count);
  moved.normals.reserve(std::size_t(topology.face_count));
  const PolyhedronFault report = complete_moved_polyhedron(moved);
  if (report.fault != Fault::none) refuse_polyhedron(report, moved.vertices);
  shape.set_polyhedron(moved);
}

}  // namespace

hs_status hs_shape_set_vertices(hs_shape* shape, hs_view vertices) {
  return guarded(context_of(shape), __func__, [&] {
    require_pointer(shape, "shape");
    return visit(*shape, [&]<int D>(Shape<D>& s) {
      if (vertices.count != s.vertex_count()) {
        refuse(HS_ERROR_ARGUMENT, "vertices.count is %lld; it must be the shape's number of vertices, %d",
               static_cast<long long>(vertices.count), s.vertex_count());
      }
      TemporaryMemory memory(&shape->context->memory);
      set_vertices(s, vertices, memory.get());
      return HS_OK;
    });
  });
}
