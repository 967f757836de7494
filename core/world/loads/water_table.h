#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/finite.h"
#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

/// The depth below a water table where its height is linear. The vertical axis is the last one.
template <int D>
struct WaterDepth {
  double at(const Vector<D>& place) const { return gradient.dot(place - on_table); }

  Vector<D> on_table = Vector<D>::Zero();  // a point
  Vector<D> gradient = -Vector<D>::Unit(D - 1);
};

/// The maximum slope of a table, so that depths stay finite.
constexpr double max_water_slope = 1e6;

/// A water table. In 2D a polyline whose corners ascend in x, level beyond its ends; two corners above each
/// other are a step. In 3D a plane.
template <int D>
class WaterTable {
 public:
  explicit WaterTable(Memory* memory) : corners_(memory) {}

  /// In 3D one corner is the height of a level plane, and three corners span a plane that is not vertical.
  void set(Array<Vector<D>>&& corners) {
    corners_ = std::move(corners);
    prepare();
  }
  bool empty() const { return corners_.empty(); }
  /// The largest magnitude of the gradient of the depth.
  double steepest() const;

  /// Calls visit(depth, first, last) for each part of the table above the interval from `from` to `to` of the
  /// first coordinate, with the interval of the part.
  template <class Visit>
  void for_each_part(double from, double to, Visit visit) const;

  bool is_consistent() const {
    return all(corners_, [](const Vector<D>& corner) { return all_finite(corner); }) && is_table();
  }
  /// Are the corners those of a table, and is it not too steep?
  bool is_table() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(corners_);
    if constexpr (Archive::reads) prepare();
  }

 private:
  void prepare();

  Array<Vector<D>> corners_;
  WaterDepth<D> plane_;  // only in 3D
};

// Their specializations, which no use may precede.
template <>
void WaterTable<2>::prepare();
template <>
void WaterTable<3>::prepare();
template <>
double WaterTable<2>::steepest() const;
template <>
double WaterTable<3>::steepest() const;
template <>
bool WaterTable<2>::is_table() const;
template <>
bool WaterTable<3>::is_table() const;

/// The depth below a level line, and below the line through two corners at different x.
inline WaterDepth<2> depth_below(const Vector<2>& corner) { return {corner, {0, -1}}; }
inline WaterDepth<2> depth_below(const Vector<2>& a, const Vector<2>& b) {
  return {a, {(b.y() - a.y()) / (b.x() - a.x()), -1}};
}

template <>
template <class Visit>
void WaterTable<2>::for_each_part(double from, double to, Visit visit) const {
  const auto is_before = [](double x, const Vector<2>& corner) { return x < corner.x(); };
  const std::size_t count = corners_.size();
  std::size_t next =
      std::size_t(std::upper_bound(corners_.begin(), corners_.end(), from, is_before) - corners_.begin());
  // The part between corner next - 1 and corner next.
  for (; next <= count; ++next) {
    const double begin = next == 0 ? -HUGE_VAL : corners_[next - 1].x();
    const double end = next == count ? HUGE_VAL : corners_[next].x();
    if (begin > to) return;
    if (begin == end) continue;
    visit(next == 0       ? depth_below(corners_.front())
          : next == count ? depth_below(corners_.back())
                          : depth_below(corners_[next - 1], corners_[next]),
          begin, end);
  }
}

template <>
template <class Visit>
void WaterTable<3>::for_each_part(double, double, Visit visit) const {
  visit(plane_, -HUGE_VAL, HUGE_VAL);
}

}  // namespace halfspace
