#pragma once

#include <optional>
#include <string>
#include <vector>

#include "faults.h"
#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// Makes what a scene describes, and tells what is wrong with a description at its place in the file. A shape
/// that cannot be made is null.
class CheckedShapes {
 public:
  CheckedShapes(const Context& context, int dimension, Faults& faults)
      : context_(context), dimension_(dimension), faults_(faults) {}

  /// None, or more than one only for the blocks of a file or a boundary.
  std::vector<Shape> of(const Block& block);
  Shape of(const Region& region);

 private:
  Shape polygon(const std::vector<Point>& vertices, const std::string& key, Place place);
  Shape polyhedron(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                   std::optional<double> tolerance, const std::string& key, Place place);
  std::vector<Shape> from_file(const Block& block);
  std::vector<Shape> from_boundary(const Block& block);

  const Context& context_;
  int dimension_;
  Faults& faults_;
};

}  // namespace halfspace::cli
