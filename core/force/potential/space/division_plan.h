#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/outline.h"

namespace halfspace {

/// A plan is the cached division of two blocks' overlap into the cells of their nearest faces: the faces that
/// meet at its corners, and the corners of its cells. While this topology is valid, the corners are computed
/// from their faces, and nothing is cut.
///
/// A plan is a list of small numbers:
///
/// - for a, then for b: the relevant ones of each four faces, as bits; count and indices of these;
/// - planes between faces of one block, of points equally deep behind both: count, two planes of each;
/// - corners that are vertices of a: count, these; likewise of b; then others: count, three planes of each;
/// - the overlap: the corner that its tetrahedra share, count of these, the others of each;
/// - for a, then for b, the division by its nearest faces:
///   - the faces nearest to corners that are not on them: count, depth of each;
///   - the faces that contain corners of the overlap: count, depth of each;
///   - cells: count of the first faces, which have them; count of tetrahedra, face and four corners of each.
///
/// Planes and corners are numbered in order. In the division of a block its relevant faces are numbered from
/// 0; plan_depth() is the index of a corner's depth behind one. The count of tetrahedra is a multiple of
/// four; the last ones may have no volume.
using PlanCode = std::int16_t;

constexpr int most_plan_faces = 32;      // of a block
constexpr int most_plan_corners = 128;   // of the overlap, and of all cells
constexpr int most_planes_between = 96;  // faces of a block
constexpr int most_plan_planes = 2 * most_plan_faces + most_planes_between;
constexpr std::size_t most_plan_codes = 4096;
constexpr int most_faces_to_plan = 1024;  // of a block, relevant or not

constexpr int plan_depth(int face, int corner) { return most_plan_corners * face + corner; }
constexpr int corner_of_plan_depth(int number) { return int(unsigned(number) % most_plan_corners); }

/// Depths that differ by less than the first fraction of the blocks' size are equal when a plan is made, well
/// above the rounding of the cutter. When it is evaluated, differences below the second fraction are
/// rounding: this detects a false coincidence before the plan is used.
constexpr double plan_rounding_made = 0x1p-34;
constexpr double plan_rounding_followed = 0x1p-44;
/// The largest component of `to_b` plus the largest offset of the relevant faces.
inline double plan_size(const Vector<3>& to_b, double largest_offset) {
  return to_b.cwiseAbs().maxCoeff() + largest_offset;
}

/// False for a plan of a damaged snapshot.
bool is_plan(std::span<const PlanCode> plan, const Outline<3>& a, const Outline<3>& b);

}  // namespace halfspace
