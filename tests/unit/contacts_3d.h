#pragma once

#include <vector>

#include "narrow_phase/pair.h"
#include "polyhedra.h"

namespace halfspace::test {

using Pair = PotentialPair<3>;

constexpr double pi = 3.14159265358979323846;
const Vector<3> x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

Cloud prism(const Points& base, double height);
/// Six corners on the axes.
Cloud octahedron(double x, double y, double z);
/// A ridge along x below and one above.
Cloud wedge(double length, double half_width, double height);
Cloud turned(Cloud points, const Eigen::Matrix3d& turn);
Cloud turned(Cloud points, double angle, const Vector<3>& axis);
Cloud scaled(Cloud points, double factor);

/// The hull as a shape.
Shape<3> block_of(const Cloud& points);
/// The same, turned with its edges and faces counted as before.
Shape<3> turned_block(const Cloud& points, double about_x, double then_about_z);
/// Hull of random points on a sphere.
Shape<3> random_block(Random& random, int count);

/// The potential pair of largest gap by definition: of every face, and of every two edges.
Separation<3> pair_of_largest_gap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b);

struct Met {
  Contact<3> contact;
  PairCache<3> witness;
};

/// As a step of a run meets two blocks; the contact is none when they are apart.
Met meet(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b, const PairCache<3>& witness = {},
         const DetectOptions& options = {});

/// Memory of blocks that touch through the face of a that looks most along a direction.
PairCache<3> touching_through(const Shape<3>& a, const Vector<3>& direction);
/// The same pair seen from the other block.
PairCache<3> swapped(const PairCache<3>& witness);

/// What holds of every contact of blocks that overlap, whatever its type: its points lie on the contact plane
/// and in the block whose face or edge that is, and as far along the normal as the gap is, in the other.
void check_by_definition(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b,
                         const Contact<3>& contact);

}  // namespace halfspace::test
