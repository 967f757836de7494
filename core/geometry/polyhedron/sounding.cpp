#include "geometry/polyhedron/sounding.h"

#include <cmath>

#include "simd/two_lanes.h"

namespace halfspace {

DepthRange sound(std::size_t count, const double* x, const double* y, const double* z,
                 const Halfspace<3>& plane, double* depths) {
  const TwoLanes nx = both(plane.normal.x()), ny = both(plane.normal.y()), nz = both(plane.normal.z());
  const TwoLanes offset = both(plane.offset);
  TwoLanes least = both(HUGE_VAL), most = both(-HUGE_VAL);
  for (std::size_t v = 0; v < count; v += 2) {
    const TwoLanes depth = offset - (nx * load_two(x + v) + ny * load_two(y + v) + nz * load_two(z + v));
    store_two(depths + v, depth);
    least = min(least, depth);
    most = max(most, depth);
  }
  return {std::min(least[0], least[1]), std::max(most[0], most[1])};
}

}  // namespace halfspace
