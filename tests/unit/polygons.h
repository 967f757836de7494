#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shape.h"

namespace halfspace::test {

using Points = std::vector<Vector<2>>;

/// A small generator that gives the same numbers everywhere (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  double uniform(double lower, double upper);
  int integer(int lower, int upper);  // both included

 private:
  std::uint64_t state_;
};

/// Components between -1 and 1, such as rates of strain.
template <int D>
Tensor<D> random_tensor(Random& random) {
  Tensor<D> tensor;
  for (double& component : tensor.reshaped()) component = random.uniform(-1, 1);
  return tensor;
}

Points regular_polygon(int count, double radius, double phase = 0);
/// Hull of random points on a jittered circle.
Points random_polygon(Random& random, int max_vertices, double radius);
Points rectangle(double width, double height, const Vector<2>& center = {0, 0});
Shape<2> shape_of(const Points& points);

}  // namespace halfspace::test
