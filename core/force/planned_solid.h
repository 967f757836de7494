#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "force/corner_set.h"
#include "geometry/vector.h"

namespace halfspace {

/// A convex solid by the corners that lie in each of its facets.
class PlannedSolid {
 public:
  using Tetrahedron = std::array<int, 4>;  // its corners

  explicit PlannedSolid(Memory* memory) : facets_(memory) {}

  void reserve() { facets_.reserve(3 * most_plan_faces); }
  /// The corners are read until the next one is begun.
  void begin(std::span<const Vector<3>> corners) {
    at_ = corners;
    facets_.clear();
  }
  void add_facet(const CornerSet& corners, const Vector<3>& outward);

  /// Whether nothing is missing: along each edge there are two facets, one on either side.
  bool close();

  /// Shows tetrahedra that make it up, and returns their volume. They have one corner in common: that in most
  /// facets, which makes them the fewest.
  template <class Show>
  double divide(Show show) const {
    const int top = corner_in_most_facets();
    double volume = 0;
    for (const Facet& facet : facets_) {
      if (facet.corners.has(top)) continue;
      for (int i = 1; i + 1 < facet.corners.count(); ++i) {
        const Tetrahedron corners{top, facet.around[0], facet.around[i], facet.around[i + 1]};
        volume += volume_of(corners);
        show(corners);
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
  int corner_in_most_facets() const;
  double volume_of(const Tetrahedron& corners) const;

  std::span<const Vector<3>> at_;
  Array<Facet> facets_;
};

}  // namespace halfspace
