#pragma once

#include <cstdint>
#include <span>

#include "force/potential/space/corner_set.h"
#include "geometry/vector.h"

namespace halfspace {

/// A convex solid by the corners that lie in each of its facets.
class PlannedSolid {
 public:
  explicit PlannedSolid(Memory* memory) : facets_(memory) {}

  void reserve() { facets_.reserve(3 * most_plan_faces); }
  /// The corners are read until the next one is begun.
  void begin(std::span<const Vector<3>> corners) {
    at_ = corners;
    facets_.clear();
  }
  void add_facet(const CornerSet& corners, const Vector<3>& outward);

  /// Goes around all facets. False when something is missing: along each edge there are two facets, one on
  /// either side.
  bool close();

  /// A corner in most facets: tetrahedra that share it are the fewest.
  int top() const;
  /// Shows the other corners of each, once the facets have been gone around, and returns the volume of all.
  template <class Show>
  double divide(int top, Show show) const {
    double volume = 0;
    for (const Facet& facet : facets_) {
      if (facet.corners.has(top)) continue;
      for (int i = 1; i + 1 < facet.corners.count(); ++i) {
        const int p = facet.around[0], q = facet.around[i], r = facet.around[i + 1];
        volume += volume_of(top, p, q, r);
        show(p, q, r);
      }
    }
    return volume;
  }

 private:
  struct Facet {
    Vector<3> outward;
    CornerSet corners;
    std::uint8_t around[most_plan_corners];  // counter-clockwise seen from outside
  };

  void go_around(Facet& facet) const;
  double volume_of(int top, int p, int q, int r) const;

  std::span<const Vector<3>> at_;
  Array<Facet> facets_;
};

}  // namespace halfspace
