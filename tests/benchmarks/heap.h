#pragma once

// A settled heap of random triangles in a bin, and wide boxes made of many such bins side by side: any number
// of blocks in the same packing, without settling them all.

#include <cstdint>
#include <vector>

#include "random_polygon.h"

namespace halfspace_benchmark {

/// A grain of the bin at rest. Vertices about its centroid.
struct Grain {
  Points vertices;
  Point position;
  double angle = 0;
};

/// Shear force of a contact between two blocks of the bin, each a grain's index or one of the walls below.
struct ShearSpring {
  int a = 0;
  int b = 0;
  double force[3] = {};  // on b
};
enum Wall { floor_wall = -1, left_wall = -2, right_wall = -3 };

/// Interior from (0, 0) to (width, height), open above.
struct Bin {
  double width = 0;
  double height = 0;
  std::vector<Grain> grains;
  std::vector<ShearSpring> springs;
  double settling_time = 0;  ///< simulated until it was at rest, s
  double largest_speed = 0;  ///< left at the end, m/s
};

inline constexpr double wall_thickness = 0.02;

/// Lets columns x rows grains of about 0.02 m fall into a bin, until no grain is faster than 1 mm/s or the
/// time given has passed.
Bin settle_bin(int columns, int rows, double most_time, Random& random);

/// One floor under all, a wall on both sides of every bin; a fixed box is given by its corners.
struct Box {
  Point low;
  Point high;
};
Box floor_of(const Bin& bin, int bins);
Box wall_of(const Bin& bin, int index);

/// How far a bin stands from the one before.
inline double spacing(const Bin& bin) { return bin.width + wall_thickness; }

/// The order in which blocks are added. At random, neighbours in space are strangers in memory.
enum class Order { bin_by_bin, random, along_curve };

/// `bins` bins in one world, at rest.
halfspace_test::World make_heap(hs_context* context, const Bin& bin, int bins, Order order, Random& random);

}  // namespace halfspace_benchmark
