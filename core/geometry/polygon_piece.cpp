#include "geometry/polygon_piece.h"

namespace halfspace {
namespace {

/// In place of a part that nobody wants.
struct NoVertices {
  void begin(std::size_t) {}
  void add(double, double, double, bool = true) {}
  void end() {}
};

/// One step of Sutherland and Hodgman (1974), for both sides.
template <class Outside>
void part_at_plane(const PolygonView& whole, const Sounding& sounding, PieceVertices& inside,
                   Outside& outside) {
  const std::size_t most = 2 * std::size_t(whole.vertex_count);
  inside.begin(most);
  outside.begin(most);
  int before = whole.vertex_count - 1;
  for (int here = 0; here < whole.vertex_count; ++here) {
    const bool was_inside = sounding.is_inside(before), is_inside = sounding.is_inside(here);
    if (was_inside != is_inside) {
      const int inner = was_inside ? before : here, outer = was_inside ? here : before;
      add_between(whole, inner, outer, sounding.share_inside(inner, outer),
                  [&](double x, double y, double z) {
                    inside.add(x, y, z);
                    outside.add(x, y, z);
                  });
    }
    inside.add(whole.x[here], whole.y[here], whole.z[here], is_inside);
    outside.add(whole.x[here], whole.y[here], whole.z[here], !is_inside);
    before = here;
  }
  inside.end();
  outside.end();
}

}  // namespace

void PolygonPiece::Cutter::part(const PolygonView& whole, const Sounding& sounding, PolygonPiece& inside,
                                PolygonPiece& outside) {
  part_at_plane(whole, sounding, inside.vertices_, outside.vertices_);
}

void PolygonPiece::Cutter::keep_inside(const PolygonView& whole, const Sounding& sounding,
                                       PolygonPiece& inside) {
  NoVertices outside;
  part_at_plane(whole, sounding, inside.vertices_, outside);
}

VolumeAndMoment measure(const PolygonView& base) {
  if (base.vertex_count == 0) return {};
  const double *x = base.x, *y = base.y, *z = base.z;
  double sum = 0, sum_x = 0, sum_y = 0, sum_z = 0;
  for (int q = 1, r = 2; r < base.vertex_count; q = r++) {
    const double volume = x[0] * (y[q] * z[r] - z[q] * y[r]) + y[0] * (z[q] * x[r] - x[q] * z[r]) +
                          z[0] * (x[q] * y[r] - y[q] * x[r]);
    sum += volume;
    sum_x += volume * (x[0] + x[q] + x[r]);
    sum_y += volume * (y[0] + y[q] + y[r]);
    sum_z += volume * (z[0] + z[q] + z[r]);
  }
  return {sum / 6, {sum_x / 24, sum_y / 24, sum_z / 24}};
}

}  // namespace halfspace
