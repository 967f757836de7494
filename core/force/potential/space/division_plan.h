#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/outline.h"

namespace halfspace {

/// What two blocks have in common, and how it is divided among the faces that its points are nearest to, told
/// by which faces meet at its corners and which corners its cells have. While blocks hardly move it stays as
/// it is: then the corners are found from their faces, and nothing has to be cut.
///
/// A plan is a list of small numbers:
///
/// - for a, then for b: which of each four of its faces matter, bit by bit; count of these, which they are;
/// - planes between faces of one block, on which points are as deep behind either: count, two planes of each;
/// - corners that are vertices of a: count, these; likewise of b; then others: count, three planes of each;
/// - what the blocks have in common: a corner that its tetrahedra share, count of these, the others of each;
/// - for a, then for b, what is divided by the nearest of its faces:
///   - the faces that corners are nearest to, but not on: count, depth of each;
///   - the faces that corners of what the blocks have in common are on: count, depth of each;
///   - cells: count of the first faces, which have them; count of tetrahedra, face and four corners of each.
///
/// Planes and corners are numbered as they come. Where a block is divided its faces that matter count from 0;
/// the depth of a corner behind one has the number that plan_depth() says. The count of tetrahedra is a
/// multiple of four, the last ones may have no volume.
using PlanCode = std::int16_t;

constexpr int most_plan_faces = 32;      // of a block
constexpr int most_plan_corners = 128;   // of what the blocks have in common, and of all cells
constexpr int most_planes_between = 96;  // faces of a block
constexpr int most_plan_planes = 2 * most_plan_faces + most_planes_between;
constexpr std::size_t most_plan_codes = 4096;
constexpr int most_faces_to_plan = 1024;  // of a block, whether they matter or not

constexpr int plan_depth(int face, int corner) { return most_plan_corners * face + corner; }
constexpr int corner_of_plan_depth(int number) { return int(unsigned(number) % most_plan_corners); }

/// Depths that differ by less than this share of the blocks' size are taken for one where a plan is made: so
/// far the cutter may round. Whether they are is then told as in every step: who follows a plan takes for
/// rounding what is below the second one.
constexpr double plan_rounding_made = 0x1p-34;
constexpr double plan_rounding_followed = 0x1p-44;
/// By the way between the blocks, and the largest offset of the faces that matter.
inline double plan_size(const Vector<3>& to_b, double largest_offset) {
  return to_b.cwiseAbs().maxCoeff() + largest_offset;
}

/// False for what is no plan for these blocks, after reading a snapshot.
bool is_plan(std::span<const PlanCode> plan, const Outline<3>& a, const Outline<3>& b);

}  // namespace halfspace
