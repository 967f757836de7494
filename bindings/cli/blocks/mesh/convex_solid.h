#pragma once

#include <optional>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/solid.h"
#include "model/library.h"

namespace halfspace::cli {

/// A polyhedron fitted to a solid, and the report of the fit.
struct ConvexSolid {
  Shape shape;
  hs_fit_report report{};
  double tolerance = 0;  ///< m: within which it was fitted
};

/// The fault of a solid that is not convex within the tolerance.
class NotConvex : public MeshFault {
 public:
  NotConvex(const std::string& place, const std::string& text, double sufficient)
      : MeshFault(place, text), sufficient_tolerance(sufficient) {}
  double sufficient_tolerance;  ///< m; 0 if there is none
};

/// Fits a polyhedron to a solid; `scale` is the unit of its lengths in m. Facets that are coplanar within the
/// tolerance are merged, and dents up to it are accepted. Default tolerance: 2 units of the last digit of the
/// file's coordinates, as a vertex is rounded by half a unit along each axis; at most 2^-7 of the solid's
/// size, as coordinates of few digits may be exact. @throws MeshFault
ConvexSolid make_convex(const Context& context, const Solid& solid, double scale,
                        std::optional<double> tolerance = {});

/// True if the faces run clockwise seen from outside.
bool is_inside_out(const Solid& solid);

}  // namespace halfspace::cli
