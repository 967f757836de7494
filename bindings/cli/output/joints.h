#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace halfspace::cli {

/// A joint between two rigid blocks: the common part of a face of each.
struct Joint {
  std::size_t a = 0, b = 0;         ///< indices of the blocks
  std::vector<Point> corners = {};  ///< at the start; 2D: the ends of the common part of two edges
  Point normal{};                   ///< at the start, of unit length, from a to b
  double size = 0;                  ///< length in 2D, area in 3D
};

/// The joints of blocks that do not strain. Faces are common if they are parallel within a degree and closer
/// than a hundredth of the smaller block.
std::vector<Joint> joints_of(const Layout& layout, const Frame& start);

/// The two sides of a joint later, each carried along by its block.
struct JointSides {
  std::vector<Point> of_a, of_b;
  Point normal{};
  std::vector<double> gaps;  ///< at each corner, m, along the normal

  double opening() const;  ///< the largest gap
  Point centre() const;    ///< of a's side
};

JointSides sides_of(const Joint& joint, const Frame& start, const Frame& now);

/// joints.csv: a row for each joint, with the resultant of its contacts.
std::string joints_table(const Layout& layout, const Frame& start, const Frame& now,
                         const std::vector<hs_contact>& contacts);

}  // namespace halfspace::cli
