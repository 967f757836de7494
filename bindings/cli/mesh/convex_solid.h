#pragma once

#include <optional>

#include "library.h"
#include "mesh/mesh_fault.h"
#include "mesh/solid.h"

namespace halfspace::cli {

/// A polyhedron made of a solid, and how far that is from the solid.
struct ConvexSolid {
  Shape shape;
  hs_fit_report report{};
  double tolerance = 0;  ///< m: within which it was fitted
};

/// What is wrong with a solid that is not convex.
class NotConvex : public MeshFault {
 public:
  NotConvex(const std::string& place, const std::string& text, double sufficient)
      : MeshFault(place, text), sufficient_tolerance(sufficient) {}
  double sufficient_tolerance;  ///< m: one that would do, 0 if there is none
};

/// Makes a polyhedron of a solid whose lengths are in units of so many m. Faces that are plane within the
/// tolerance are one, and dents up to it are taken. By default it is 2 units of the last digit of the file's
/// coordinates, above the rounding of a vertex by half a unit along each axis, and at most 2^-7 of the
/// solid's size, as coordinates of few digits may well be exact. @throws MeshFault
ConvexSolid make_convex(const Context& context, const Solid& solid, double scale,
                        std::optional<double> tolerance = {});

/// Do the faces run clockwise seen from outside?
bool is_inside_out(const Solid& solid);

}  // namespace halfspace::cli
