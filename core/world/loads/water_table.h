#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

/// A part of a table on which its height is linear: between vertical planes.
template <int D>
struct WaterPart {
  WaterDepth<D> depth = {};
  Vector<D> low = Vector<D>::Constant(-HUGE_VAL);  // of the horizontal coordinates; the last one is not used
  Vector<D> high = Vector<D>::Constant(HUGE_VAL);
  // One half of a cell of a height map: where side . (place - on_table) >= 0.
  bool is_half = false;
  Vector<D> side = Vector<D>::Zero();
};

/// The maximum slope of a table, so that depths stay finite.
constexpr double max_water_slope = 1e6;

/// A water table. In 2D a polyline whose corners ascend in x, level beyond its ends; two corners above each
/// other are a step. In 3D a plane, or a height map: points above a rectangular grid, with two triangles
/// between four of them, that goes on beyond its border with the heights there.
template <int D>
class WaterTable {
 public:
  explicit WaterTable(Memory* memory) : corners_(memory) {}

  /// In 3D one corner is the height of a level plane, and three corners span a plane that is not vertical.
  /// `columns`: the number of corners in each row of a height map, with rows in ascending order of y; 0 for
  /// other tables.
  void set(Array<Vector<D>>&& corners, std::int64_t columns = 0) {
    corners_ = std::move(corners);
    columns_ = columns;
    prepare();
  }
  bool empty() const { return corners_.empty(); }
  /// The largest magnitude of the gradient of the depth.
  double steepest() const { return steepest_; }

  /// Calls visit(part) for each part of the table above the box from `low` to `high`.
  template <class Visit>
  void for_each_part(const Vector<D>& low, const Vector<D>& high, Visit visit) const;

  bool is_consistent() const {
    return all(corners_, [](const Vector<D>& corner) { return all_finite(corner); }) && is_table();
  }
  /// Are the corners those of a table, and is it not too steep?
  bool is_table() const { return is_in_order() && steepest_ <= max_water_slope; }

  template <class Archive>
  void visit(Archive& archive) {
    archive(corners_, columns_);
    if constexpr (Archive::reads) prepare();
  }

 private:
  void prepare();
  bool is_in_order() const;
  template <class Visit>
  void visit_cell(std::size_t column, std::size_t row, Visit visit) const;

  Array<Vector<D>> corners_;
  std::int64_t columns_ = 0;
  double steepest_ = 1;
  WaterDepth<D> plane_;  // only in 3D, without a height map
};

// Their specializations, which no use may precede.
template <>
void WaterTable<2>::prepare();
template <>
void WaterTable<3>::prepare();
template <>
bool WaterTable<2>::is_in_order() const;
template <>
bool WaterTable<3>::is_in_order() const;

/// The depth below a level line, and below the line through two corners at different x.
inline WaterDepth<2> depth_below(const Vector<2>& corner) { return {corner, {0, -1}}; }
inline WaterDepth<2> depth_below(const Vector<2>& a, const Vector<2>& b) {
  return {a, {(b.y() - a.y()) / (b.x() - a.x()), -1}};
}

/// Calls visit(next) for each interval between ascending coordinates that meets the one from `from` to `to`:
/// it ends at coordinate `next`, and has no end if that is their count.
template <class At, class Visit>
void for_each_interval(std::size_t count, At at, double from, double to, Visit visit) {
  std::size_t next = 0, past = count;
  while (next < past) {
    const std::size_t middle = next + (past - next) / 2;
    if (at(middle) > from) {
      past = middle;
    } else {
      next = middle + 1;
    }
  }
  for (; next <= count && (next == 0 || at(next - 1) <= to); ++next) visit(next);
}

template <>
template <class Visit>
void WaterTable<2>::for_each_part(const Vector<2>& low, const Vector<2>& high, Visit visit) const {
  const std::size_t count = corners_.size();
  const auto x_of = [&](std::size_t corner) { return corners_[corner].x(); };
  for_each_interval(count, x_of, low.x(), high.x(), [&](std::size_t next) {
    WaterPart<2> part;
    if (next > 0) part.low.x() = x_of(next - 1);
    if (next < count) part.high.x() = x_of(next);
    if (part.low.x() == part.high.x()) return;
    part.depth = next == 0       ? depth_below(corners_.front())
                 : next == count ? depth_below(corners_.back())
                                 : depth_below(corners_[next - 1], corners_[next]);
    visit(part);
  });
}

/// Visits both halves of the cell that ends at a column and at a row; beyond the border the cell has no end.
template <>
template <class Visit>
void WaterTable<3>::visit_cell(std::size_t column, std::size_t row, Visit visit) const {
  const std::size_t columns = std::size_t(columns_), rows = corners_.size() / columns;
  const std::size_t x0 = column - (column > 0), x1 = std::min(column, columns - 1);
  const std::size_t y0 = row - (row > 0), y1 = std::min(row, rows - 1);
  const auto corner = [&](std::size_t x, std::size_t y) { return corners_[y * columns + x]; };
  const Vector<3> first = corner(x0, y0), last = corner(x1, y1);
  WaterPart<3> part;
  if (column > 0) part.low.x() = first.x();
  if (column < columns) part.high.x() = last.x();
  if (row > 0) part.low.y() = first.y();
  if (row < rows) part.high.y() = last.y();
  const double width = last.x() - first.x(), length = last.y() - first.y();
  const auto slope = [](double from, double to, double over) { return over > 0 ? (to - from) / over : 0.0; };
  part.depth.on_table = first;
  part.is_half = width > 0 && length > 0;
  // The diagonal leads from the first corner to the last one.
  for (const bool is_below : {true, false}) {
    const double between = is_below ? corner(x1, y0).z() : corner(x0, y1).z();
    const double along_x = is_below ? slope(first.z(), between, width) : slope(between, last.z(), width);
    const double along_y = is_below ? slope(between, last.z(), length) : slope(first.z(), between, length);
    part.depth.gradient = {along_x, along_y, -1};
    if (part.is_half) part.side = (is_below ? 1 : -1) * Vector<3>(1 / width, -1 / length, 0);
    visit(part);
    if (!part.is_half) return;
  }
}

template <>
template <class Visit>
void WaterTable<3>::for_each_part(const Vector<3>& low, const Vector<3>& high, Visit visit) const {
  if (columns_ == 0) return visit(WaterPart<3>{.depth = plane_});
  const std::size_t columns = std::size_t(columns_), rows = corners_.size() / columns;
  const auto x_of = [&](std::size_t column) { return corners_[column].x(); };
  const auto y_of = [&](std::size_t row) { return corners_[row * columns].y(); };
  for_each_interval(rows, y_of, low.y(), high.y(), [&](std::size_t row) {
    for_each_interval(columns, x_of, low.x(), high.x(),
                      [&](std::size_t column) { visit_cell(column, row, visit); });
  });
}

}  // namespace halfspace
