#include "world/loads/water_table.h"

namespace halfspace {

template <>
void WaterTable<2>::prepare() {}

template <>
double WaterTable<2>::steepest() const {
  double steepest = 1;
  if (empty()) return steepest;
  for_each_part(-HUGE_VAL, HUGE_VAL, [&](const WaterDepth<2>& depth, double, double) {
    steepest = std::max(steepest, depth.gradient.norm());
  });
  return steepest;
}

template <>
bool WaterTable<2>::is_table() const {
  const auto is_left = [](const Vector<2>& a, const Vector<2>& b) { return a.x() < b.x(); };
  return std::is_sorted(corners_.begin(), corners_.end(), is_left) && steepest() <= max_water_slope;
}

template <>
void WaterTable<3>::prepare() {
  plane_ = {};
  if (corners_.empty()) return;
  plane_.on_table = corners_[0];
  if (corners_.size() < 3) return;
  const Vector<3> normal = cross_product(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  plane_.gradient = -normal / normal.z();
}

template <>
double WaterTable<3>::steepest() const {
  return plane_.gradient.norm();
}

template <>
bool WaterTable<3>::is_table() const {
  return (corners_.empty() || corners_.size() == 1 || corners_.size() == 3) && steepest() <= max_water_slope;
}

}  // namespace halfspace
