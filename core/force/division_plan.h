#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

/// What two blocks have in common, and how it is divided among the faces that its points are nearest to, told
/// by which faces meet at its corners and which corners its cells have. While blocks hardly move it stays as
/// it is: then the corners are found from their faces, and nothing has to be cut.
///
/// A plan is a list of small numbers:
///
/// - for a, then for b: count of the faces that matter, these;
/// - corners that are vertices of a: count, these; likewise of b; then others: count, three faces of each;
/// - a solid: what the blocks have in common;
/// - for a, then for b, what is divided by the nearest of its faces:
///   - further corners: count, three pairs of faces of each: it is as deep behind either, or on one whose
///     partner is none;
///   - which faces a corner is nearest to: count, corner and face of each;
///   - which faces a corner is on: count, corner and face of each;
///   - cells: count, face and solid of each.
///
/// A solid: the corner that its tetrahedra have in common; of each fan of triangles that make these with it
/// the count of triangles, the corner that they have in common, and the corners along the other sides; 0.
///
/// Faces are numbered as listed, in pairs and triples those of b after those of a, and none after them.
/// Corners are numbered as they come, the further ones of a and of b from the same number on.
using PlanCode = std::int16_t;

constexpr int most_plan_faces = 32;    // of a block
constexpr int most_plan_corners = 64;  // of what the blocks have in common and of the cells of one of them
constexpr std::size_t most_plan_codes = 4096;
constexpr int most_faces_to_plan = 1024;  // of a block, whether they matter or not

/// Distances below this share of the blocks' size are rounding, where a plan is made and where it is
/// followed: what is made out to lie together still does when it is looked at again.
constexpr double plan_rounding_made = 0x1p-46;
constexpr double plan_rounding_followed = 0x1p-44;
/// By the way between the blocks, and the largest offset of the faces that matter.
inline double plan_size(const Vector<3>& to_b, double largest_offset) {
  return to_b.cwiseAbs().maxCoeff() + largest_offset;
}

}  // namespace halfspace
