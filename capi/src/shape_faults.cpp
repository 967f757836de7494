#include "shape_faults.h"

#include "require.h"

namespace halfspace::capi {

void refuse_polygon(const FaultReport& report, const char* name, const Array<Vector<2>>& vertices) {
  refuse_points<2>(vertices, report.vertex, name, name, fault_text(report.fault));
}

void refuse_polyhedron(const PolyhedronFault& report, const Array<Vector<3>>& vertices) {
  const char* const text = fault_text(report.fault);
  const auto vertex = static_cast<long long>(report.vertex), face = static_cast<long long>(report.face);
  if (report.face >= 0 && report.vertex >= 0)
    refuse(HS_ERROR_GEOMETRY, "face %lld %s: vertices[%lld]", face, text, vertex);
  if (report.face >= 0) refuse(HS_ERROR_GEOMETRY, "face %lld %s", face, text);
  refuse_points<3>(vertices, report.vertex, "vertices", "vertices", text);
}

}  // namespace halfspace::capi
