#pragma once

#include <cmath>
#include <limits>
#include <random>

namespace halfspace_test {

inline double uniform_between(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}
inline int whole_between(std::mt19937_64& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

/// At what gap to lay a pair whose smaller one has the size given.
inline double draw_gap(double size, std::mt19937_64& random) {
  switch (whole_between(random, 0, 5)) {
    case 0:
      return 0.1 * size;  // far
    case 1:
      return 1e-3 * size;  // near
    case 2:
      return whole_between(random, -30, 30) * std::numeric_limits<double>::epsilon() * size;  // grazing
    case 3: {  // any order of magnitude
      const double gap = std::pow(10, uniform_between(random, -15, -3)) * size;
      return whole_between(random, 0, 1) ? gap : -gap;
    }
    case 4:
      return -1e-3 * size;  // touching
    default:
      return -0.2 * size;  // deep
  }
}

}  // namespace halfspace_test
