#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/library.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Makes the shapes of a scene, and adds faults at their places in the file. A shape that cannot be made is
/// null.
class CheckedShapes {
 public:
  CheckedShapes(const Context& context, int dimension, Faults& faults)
      : context_(context), dimension_(dimension), faults_(faults) {}

  /// The shape of a block; none after a fault, several for a file, a boundary or a concave polygon.
  std::vector<Shape> of(const Block& block);
  Shape of(const Region& region);

 private:
  /// One shape, or the parts of a concave polygon where it may be one.
  std::vector<Shape> polygon(const std::vector<Point>& vertices, bool may_be_concave, const std::string& key,
                             Place place);
  std::vector<Shape> concave_polygon(const std::vector<Point>& corners, const std::string& key, Place place);
  Shape polyhedron(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                   std::optional<double> tolerance, const std::string& key, Place place);
  std::vector<Shape> from_file(const Block& block);
  void check_overlaps(const Block& block, const std::vector<Shape>& shapes);
  std::vector<Shape> from_boundary(const Block& block);

  const Context& context_;
  int dimension_;
  Faults& faults_;
};

}  // namespace halfspace::cli
