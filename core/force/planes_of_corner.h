#pragma once

#include <array>

#include "force/division_plan.h"

namespace halfspace {

/// A face, or two and the plane between them.
using FacePair = std::array<PlanCode, 2>;

/// Planes that may tell where a corner is: the first ones of too many.
class PlanesOfCorner {
 public:
  /// The normal has any length, and the depth is as many times too large.
  void add(const FacePair& faces, const Vector<3>& normal, double depth) {
    const double length = normal.norm();
    if (count_ == faces_.size() || !(length > 0)) return;
    faces_[count_] = faces;
    depth_[count_] = depth / length;
    normal_[count_++] = normal / length;
  }

  /// Moves it where three planes meet: those that are farthest from meeting in a line. False when all but do.
  bool locate(Vector<3>& at, std::array<FacePair, 3>& faces) const {
    double largest = 0;
    Vector<3> to_planes = Vector<3>::Zero();
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        const Vector<3> along = cross_product(normal_[i], normal_[j]);
        for (std::size_t k = j + 1; k < count_; ++k) {
          const double span = along.dot(normal_[k]);
          if (std::abs(span) <= largest) continue;
          largest = std::abs(span);
          faces = {faces_[i], faces_[j], faces_[k]};
          to_planes = (depth_[k] * along + depth_[i] * cross_product(normal_[j], normal_[k]) +
                       depth_[j] * cross_product(normal_[k], normal_[i])) /
                      span;
        }
      }
    at += to_planes;
    return largest > least_span;
  }

 private:
  /// The volume that the normals of the three span.
  static constexpr double least_span = 1e-6;

  std::array<FacePair, 16> faces_;
  std::array<Vector<3>, 16> normal_;
  std::array<double, 16> depth_;  // of the place where the corner was thought to be
  std::size_t count_ = 0;
};

}  // namespace halfspace
