/** @file
 *  @brief The whole public interface of libhalfspace in one include.
 *
 *  Conventions, once for all functions:
 *  - Units: SI or any consistent set. Angles in radians. Right-handed axes.
 *  - Quaternions are x, y, z, w. In 2D only z and w are used and must describe a turn about z.
 *  - A normal points from block a to block b; a gap below 0 is an overlap.
 *  - Vertices come back counter-clockwise; in 3D those of a face, seen from outside. Indices start at 0.
 *  - In 2D every z component that goes in is ignored and every one that comes out is 0; areas are
 *    lengths times unit thickness, volumes are areas times unit thickness.
 *  - A function that can fail returns ::hs_status and gives its results through pointers. On an error
 *    nothing is changed; hs_context_last_error() names the function, the argument and its value.
 *  - Numbers that go in are finite and at most 1e75, whatever their sign; what else is asked of them is said
 *    where they are.
 *  - A parameter declared as `x[]` is an array; one declared as `*x` is one value, struct or handle.
 *  - Definitions (hs_..._def, hs_pair_options) and reports (hs_shape_properties, hs_world_report) go with
 *    their size as the caller was compiled, and later versions may append to them. All other structs are
 *    fixed for the life of a soname.
 *  - Thread rule: a context and everything made from it belong to one thread at a time. Different contexts
 *    share nothing and may be used at the same time.
 *  - Floating-point traps of the host, as Fortran programs set them, are never sprung. Its rounding and flush
 *    to zero do not matter, nor do exception flags change: the library computes as processors do by default.
 *    Only hs_pair_detect() takes both as they are.
 */
#ifndef HALFSPACE_H
#define HALFSPACE_H

#include "halfspace/affine.h"
#include "halfspace/bond.h"
#include "halfspace/context.h"
#include "halfspace/contact.h"
#include "halfspace/impact.h"
#include "halfspace/law.h"
#include "halfspace/mesh.h"
#include "halfspace/pair.h"
#include "halfspace/plan.h"
#include "halfspace/relax.h"
#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/strength.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#endif
