#include "geometry/polyhedron/quickhull.h"

namespace halfspace {

QuickhullResult quickhull(Array<double>&, double, Array<std::int32_t>&, Array<std::int32_t>&) {
  return QuickhullResult::unavailable;
}

}  // namespace halfspace
