#include "detect/expanding_polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {

ExpandingPolytope::ExpandingPolytope(const Corner* tetrahedron) : corner_count_(4) {
  std::copy_n(tetrahedron, 4, corners_);
  double size = 0;
  for (int i = 0; i < 4; ++i) size = std::max(size, corners_[i].at.cwiseAbs().maxCoeff());
  rounding_ = 8 * std::numeric_limits<double>::epsilon() * size;
  // Counter-clockwise seen from outside when corner 3 is behind the plane of the others.
  const Vector<3> base = corners_[0].at;
  const double volume = cross_product(Vector<3>(corners_[1].at - base), Vector<3>(corners_[2].at - base))
                            .dot(corners_[3].at - base);
  if (volume > 0) std::swap(corners_[1], corners_[2]);
  add_facet(0, 1, 2);
  add_facet(0, 3, 1);
  add_facet(1, 3, 2);
  add_facet(2, 3, 0);
}

void ExpandingPolytope::add_facet(int i, int j, int k) {
  const Vector<3>& p = corners_[i].at;
  const Vector<3> normal = cross_product(Vector<3>(corners_[j].at - p), Vector<3>(corners_[k].at - p));
  const double length = normal.norm();
  Facet& facet = facets_[facet_count_++];
  // Three corners on a line span no plane: never the nearest, never seen.
  if (length == 0) {
    facet = {{i, j, k}, Vector<3>::Zero(), HUGE_VAL};
  } else {
    facet = {{i, j, k}, normal / length, normal.dot(p) / length};
  }
}

const ExpandingPolytope::Facet& ExpandingPolytope::nearest() const {
  return *std::min_element(facets_, facets_ + facet_count_,
                           [](const Facet& f, const Facet& g) { return f.offset < g.offset; });
}

/// The horizon are the edges of facets seen whose other facet is not: an edge between two that are seen comes
/// up in both directions, and cancels.
void ExpandingPolytope::remove_visible(const Vector<3>& from, Edge* horizon, int& horizon_count) {
  for (int f = 0; f < facet_count_;) {
    const bool is_visible = facets_[f].normal.dot(from) - facets_[f].offset > rounding_;
    if (!is_visible) {
      ++f;
      continue;
    }
    const Facet facet = facets_[f];
    facets_[f] = facets_[--facet_count_];
    for (int i = 0; i < 3; ++i) {
      const Edge edge{facet.corner[i], facet.corner[i == 2 ? 0 : i + 1]};
      Edge* const end = horizon + horizon_count;
      Edge* const opposite =
          std::find_if(horizon, end, [&](const Edge& e) { return e.from == edge.to && e.to == edge.from; });
      if (opposite == end) {
        horizon[horizon_count++] = edge;
      } else {
        *opposite = horizon[--horizon_count];
      }
    }
  }
}

void ExpandingPolytope::expand(const Corner& c) {
  Edge horizon[2 * most_corners];
  int horizon_count = 0;
  remove_visible(c.at, horizon, horizon_count);
  corners_[corner_count_] = c;
  for (int e = 0; e < horizon_count; ++e) add_facet(horizon[e].from, horizon[e].to, corner_count_);
  ++corner_count_;
}

}  // namespace halfspace
