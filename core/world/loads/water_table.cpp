#include "world/loads/water_table.h"

namespace halfspace {
namespace {

template <int D>
double steepest_part(const WaterTable<D>& table) {
  double steepest = 1;
  table.for_each_part(Vector<D>::Constant(-HUGE_VAL), Vector<D>::Constant(HUGE_VAL),
                      [&](const WaterPart<D>& part) {
                        // A comparison that is false for a slope that is not a number would hide it.
                        if (!(part.depth.gradient.norm() <= steepest)) steepest = part.depth.gradient.norm();
                      });
  return steepest;
}

}  // namespace

template <>
void WaterTable<2>::prepare() {
  steepest_ = empty() || !is_in_order() ? 1 : steepest_part(*this);
}

template <>
bool WaterTable<2>::is_in_order() const {
  const auto is_left = [](const Vector<2>& a, const Vector<2>& b) { return a.x() < b.x(); };
  return columns_ == 0 && std::is_sorted(corners_.begin(), corners_.end(), is_left);
}

template <>
void WaterTable<3>::prepare() {
  plane_ = {};
  steepest_ = 1;
  if (corners_.empty() || !is_in_order()) return;
  plane_.on_table = corners_[0];
  if (columns_ == 0 && corners_.size() == 3) {
    const Vector<3> normal = cross_product(corners_[1] - corners_[0], corners_[2] - corners_[0]);
    plane_.gradient = -normal / normal.z();
  }
  steepest_ = steepest_part(*this);
}

/// Each corner of a height map lies in its column and in its row.
template <>
bool WaterTable<3>::is_in_order() const {
  if (columns_ == 0) return corners_.empty() || corners_.size() == 1 || corners_.size() == 3;
  const std::size_t columns = std::size_t(columns_);
  if (columns_ < 2 || corners_.size() < 2 * columns || corners_.size() % columns != 0) return false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::size_t column = i % columns, begin = i - column;
    const bool follows = column == 0 ? i == 0 || corners_[i].y() > corners_[i - columns].y()
                                     : corners_[i].y() == corners_[begin].y();
    const bool is_in_column = begin > 0 ? corners_[i].x() == corners_[column].x()
                                        : column == 0 || corners_[i].x() > corners_[i - 1].x();
    if (!follows || !is_in_column) return false;
  }
  return true;
}

}  // namespace halfspace
