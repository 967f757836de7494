#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/vector.h"

namespace halfspace {

/// Planes that may define the place of a corner; those beyond the capacity are ignored.
class PlanesOfCorner {
 public:
  /// A face of a block, or two faces and the plane between them.
  struct Faces {
    int one, other, owner;
  };

  /// The normal has any length.
  void add(const Faces& faces, const Vector<3>& normal) {
    if (count_ < plane_.size()) plane_[count_++] = {faces, normal, normal.norm()};
  }

  /// The best conditioned three planes: those whose normals span the largest volume. None if all meet only in
  /// a line.
  std::optional<std::array<Faces, 3>> best() const {
    double best = 0, best_share = 0;
    std::array<Faces, 3> chosen;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j)
        for (std::size_t k = j + 1; k < count_; ++k) {
          const Plane &p = plane_[i], &q = plane_[j], &r = plane_[k];
          const double span = std::abs(cross_product(p.normal, q.normal).dot(r.normal));
          const double share = span / (p.length * q.length * r.length);
          if (!(span * (1 + share) > best)) continue;
          best = span * (1 + share);
          best_share = share;
          chosen = {p.faces, q.faces, r.faces};
        }
    return best_share > least_share ? std::optional(chosen) : std::nullopt;
  }

 private:
  /// Minimum volume, relative to that of orthogonal normals of the same lengths.
  static constexpr double least_share = 1e-6;

  struct Plane {
    Faces faces;
    Vector<3> normal;
    double length;
  };

  std::array<Plane, 16> plane_;
  std::size_t count_ = 0;
};

}  // namespace halfspace
