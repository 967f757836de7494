#pragma once

#include "library.h"
#include "mesh/solid.h"

namespace halfspace::cli {

/// Makes a polyhedron of a solid whose lengths are in units of so many m. It is the hull of the solid's
/// vertices, so that triangles of one plane become one face, and no vertex is moved. The solid has to be that
/// hull: each of its faces has to lie on it, within 2^-16 of the solid's size for the sake of files that
/// state coordinates by six digits or in single precision. @throws MeshFault if it is not convex
Shape make_convex(const Context& context, const Solid& solid, double scale);

/// Do the faces run clockwise seen from outside?
bool is_inside_out(const Solid& solid);

}  // namespace halfspace::cli
