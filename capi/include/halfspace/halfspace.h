/** @file
 *  @brief The public interface of libhalfspace in one include.
 *
 *  Conventions of all functions:
 *  - Units: SI or any consistent set. Angles in radians. Right-handed axes.
 *  - Quaternions are x, y, z, w. In 2D they must describe a rotation about z: x = y = 0.
 *  - A normal points from block a to block b; a gap below 0 is an overlap.
 *  - Returned vertices are counter-clockwise; in 3D those of a face, seen from outside. Indices start at 0.
 *  - In 2D z components of arguments are ignored, and those of results are 0; areas are lengths times unit
 *    thickness, volumes are areas times unit thickness.
 *  - A function that can fail returns ::hs_status and writes its results through pointers. After an error
 *    nothing has changed, but for steps or pairs completed before it; hs_context_last_error() names the
 *    function, the argument and its value.
 *  - Floating-point arguments must be finite and at most 1e75 in magnitude; narrower ranges are given for
 *    each argument.
 *  - A parameter declared as `x[]` is an array; one declared as `*x` is one value, struct or handle.
 *  - Definitions (hs_..._def, hs_pair_options) and reports (hs_shape_properties, hs_world_report) carry their
 *    size as the caller was compiled; later versions may append to them. The layout of all other structs is
 *    fixed within a soname.
 *  - Thread rule: a context and everything made from it must be used by one thread at a time, except shapes
 *    that no thread changes (shape.h). Different contexts share nothing and may be used concurrently.
 *  - The library computes in the default floating-point environment: it never triggers traps that the host
 *    has enabled (as Fortran programs do), is unaffected by the host's rounding mode and flush to zero, and
 *    leaves exception flags unchanged. Only hs_pair_detect() uses the host's rounding mode and flush to zero.
 */
#ifndef HALFSPACE_H
#define HALFSPACE_H

#include "halfspace/action.h"
#include "halfspace/affine.h"
#include "halfspace/bolt.h"
#include "halfspace/bond.h"
#include "halfspace/check.h"
#include "halfspace/compound.h"
#include "halfspace/context.h"
#include "halfspace/contact.h"
#include "halfspace/definition.h"
#include "halfspace/impact.h"
#include "halfspace/law.h"
#include "halfspace/mesh.h"
#include "halfspace/pair.h"
#include "halfspace/plan.h"
#include "halfspace/query.h"
#include "halfspace/relax.h"
#include "halfspace/share.h"
#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/strength.h"
#include "halfspace/view.h"
#include "halfspace/water.h"
#include "halfspace/world.h"

#endif
