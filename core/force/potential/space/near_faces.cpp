#include "force/potential/space/near_faces.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace halfspace {

void NearFaces::reserve(std::size_t faces, std::size_t vertices) {
  grow(corners_, 3 * vertices);
  grow(depths_, std::min<std::size_t>(faces, 32) * vertices);
  faces_.reserve(faces);
  rivals_.reserve(faces);
}

/// The last corner may count twice.
void NearFaces::begin(const ClippedPolyhedron& overlap) {
  const auto vertices = overlap.vertices();
  stride_ = vertices.size() + (vertices.size() & 1);
  grow(corners_, 3 * stride_);
  for (std::size_t i = 0; i < stride_; ++i) {
    const Vector<3> p = overlap.position(vertices[std::min(i, vertices.size() - 1)]);
    for (std::size_t axis = 0; axis < 3; ++axis) corners_[axis * stride_ + i] = p[Eigen::Index(axis)];
  }
}

/// Is no corner nearer to a face than to another? Then no point of the overlap is.
bool NearFaces::is_nowhere_nearer(const Face& face, const Face& than) const {
  const double* const depths = depths_of(face);
  return std::equal(depths, depths + stride_, depths_of(than), std::greater_equal<>());
}

/// A face behind which all of the overlap is deeper than `reach` is never the nearest, nor is one that is
/// nowhere nearer than another.
void NearFaces::find(const PlacedBlock& owner, const double* min_depth, double reach) {
  const double *const x = corners_.data(), *const y = x + stride_, *const z = y + stride_;
  faces_.clear();
  for (int f = 0; f < owner.outline.face_count(); ++f) {
    if (!(min_depth[f] <= reach)) continue;
    const Halfspace<3> plane = owner.plane(f);
    const std::size_t row = faces_.size();
    grow(depths_, (row + 1) * stride_);
    const DepthRange depths = sound(stride_, x, y, z, plane, depths_.data() + row * stride_);
    faces_.push_back({plane, depths, row});
    reach = std::min(reach, depths.most);
  }
  std::erase_if(faces_, [&](const Face& face) { return !(face.depths.least <= reach); });
  if (faces_.empty()) return;  // depths are NaN
  const auto sum = [](const Face& face) { return face.depths.least + face.depths.most; };
  const auto is_nearer = [&](const Face& e, const Face& f) { return sum(e) < sum(f); };
  std::iter_swap(faces_.begin(), std::min_element(faces_.begin(), faces_.end(), is_nearer));
  auto kept = faces_.begin();
  for (auto face = faces_.begin(); face != faces_.end(); ++face) {
    const auto covers = [&](const Face& other) { return is_nowhere_nearer(*face, other); };
    const auto covers_more = [&](const Face& other) {
      return covers(other) && !is_nowhere_nearer(other, *face);
    };
    if (std::none_of(faces_.begin(), kept, covers) && std::none_of(face + 1, faces_.end(), covers_more))
      *kept++ = *face;
  }
  faces_.erase(kept, faces_.end());
}

std::span<const std::uint32_t> NearFaces::rivals_of(std::size_t k) {
  rivals_.clear();
  for (std::size_t other = 0; other < faces_.size(); ++other) {
    if (other != k) rivals_.push_back(std::uint32_t(other));
  }
  const auto order = [&](std::uint32_t other) {
    return std::pair(-faces_[k].plane.normal.dot(faces_[other].plane.normal), other);
  };
  std::sort(rivals_.begin() + 1, rivals_.end(),
            [&](std::uint32_t e, std::uint32_t f) { return order(e) < order(f); });
  return rivals_;
}

}  // namespace halfspace
