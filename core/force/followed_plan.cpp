#include <algorithm>
#include <cmath>
#include <utility>

#include "force/field_force.h"
#include "force/placed_block.h"
#include "force/planned_force.h"
#include "geometry/two_lanes.h"

namespace halfspace {
namespace {

/// A place, or a plane: its normal and offset.
struct alignas(16) Quad {
  double x, y, z, w;
};

Quad difference(const Quad& p, const Quad& q) {
  Quad result;
  put_two_at(&result.x, two_at(&p.x) - two_at(&q.x));
  put_two_at(&result.z, two_at(&p.z) - two_at(&q.z));
  return result;
}

/// Where three planes meet: Cramer's rule.
inline Quad meeting(const Quad& p, const Quad& q, const Quad& r) {
  const auto normal = [](const Quad& plane) { return Vector<3>(plane.x, plane.y, plane.z); };
  const Vector<3> qr = cross_product(normal(q), normal(r)), rp = cross_product(normal(r), normal(p)),
                  pq = cross_product(normal(p), normal(q));
  const Vector<3> at = (p.w * qr + q.w * rp + r.w * pq) * (1 / normal(p).dot(qr));
  return {at.x(), at.y(), at.z(), 0};
}

/// Follows a plan. Where what the blocks have in common is a corner is put at the origin, so that little is
/// rounded there.
class Follower {
 public:
  Follower(const PlanCode* plan, const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b)
      : code_(plan), blocks_{{a, Vector<3>::Zero()}, {b, to_b}} {}

  std::optional<PotentialForce<3>> force() {
    find_planes();
    find_shared_corners();
    find_bounds();
    const auto [sums, top] = sum_up<SpreadSums>();
    const VolumeAndSpread content{sums.with_origin_at(top), sums.spread()};
    if (!(content.volume > 0)) return std::nullopt;
    FieldForce<3> by_a, by_b;
    if (!divide(0, content.volume, by_a) || !divide(1, content.volume, by_b)) return std::nullopt;
    PotentialForce<3> force = sum_of<3>(by_a, by_b, blocks_[0].at, blocks_[1].at,
                                        content.moment / content.volume - blocks_[0].at, content.volume);
    force.spread = content.spread;
    return force;
  }

 private:
  PlanCode next() { return *code_++; }

  void find_planes() {
    double largest_offset = 0;
    Quad* end = planes_;
    for (int owner = 0; owner < 2; ++owner) {
      face_count_[owner] = next();
      faces_[owner] = code_;
      for (int f = 0; f < face_count_[owner]; ++f) {
        const int face = next();
        const auto [normal, offset] = blocks_[owner].plane(face);
        *end++ = {normal.x(), normal.y(), normal.z(), offset};
        largest_offset = std::max(largest_offset, blocks_[owner].outline.offset[face]);
      }
    }
    *end = {0, 0, 0, 0};
    rounding_ = plan_rounding_followed * plan_size(blocks_[1].at, largest_offset);
  }

  void find_shared_corners() {
    move_to_first_corner();
    Quad* end = corners_;
    for (const PlacedBlock& block : blocks_) {
      for (int n = next(); n > 0; --n) {
        const int v = next();
        const Outline<3>& o = block.outline;
        *end++ = {o.x[v] + block.at.x(), o.y[v] + block.at.y(), o.z[v] + block.at.z(), 0};
      }
    }
    for (int n = next(); n > 0; --n, code_ += 3)
      *end++ = meeting(planes_[code_[0]], planes_[code_[1]], planes_[code_[2]]);
    shared_count_ = int(end - corners_);
  }

  void move_to_first_corner() {
    const PlanCode *of_a = code_, *of_b = of_a + 1 + of_a[0], *others = of_b + 1 + of_b[0];
    Vector<3> origin;
    if (*of_a > 0) {
      origin = blocks_[0].outline.vertex(of_a[1]) + blocks_[0].at;
    } else if (*of_b > 0) {
      origin = blocks_[1].outline.vertex(of_b[1]) + blocks_[1].at;
    } else {
      const Quad first = meeting(planes_[others[1]], planes_[others[2]], planes_[others[3]]);
      origin = {first.x, first.y, first.z};
    }
    for (PlacedBlock& block : blocks_) block.at -= origin;
    for (int f = 0; f < face_count_[0] + face_count_[1]; ++f) {
      Quad& p = planes_[f];
      p.w -= p.x * origin.x() + p.y * origin.y() + p.z * origin.z();
    }
  }

  void find_bounds() {
    TwoLanes lower_xy = both(HUGE_VAL), lower_z = lower_xy, upper_xy = -lower_xy, upper_z = -lower_xy;
    for (int c = 0; c < shared_count_; ++c) {
      const TwoLanes xy = two_at(&corners_[c].x), z = two_at(&corners_[c].z);
      lower_xy = smaller(lower_xy, xy);
      upper_xy = larger(upper_xy, xy);
      lower_z = smaller(lower_z, z);
      upper_z = larger(upper_z, z);
    }
    const Vector<3> lower(lower_xy[0], lower_xy[1], lower_z[0]), upper(upper_xy[0], upper_xy[1], upper_z[0]);
    center_ = 0.5 * (lower + upper);
    half_size_ = upper - center_;
  }

  /// Over the solid that comes next, seen from its first corner, which it returns as well.
  template <class Sums>
  std::pair<Sums, Vector<3>> sum_up() {
    Sums sums;
    const Quad& top = corners_[next()];
    const TwoLanes top_xy = two_at(&top.x), top_z = two_at(&top.z);
    const auto seen_from_top = [&](int corner) {
      return Point{two_at(&corners_[corner].x) - top_xy, two_at(&corners_[corner].z) - top_z};
    };
    for (int triangles = next(); triangles > 0; triangles = next()) {
      const Point p = seen_from_top(next());
      Point q = seen_from_top(next());
      for (; triangles > 0; --triangles) {
        const Point r = seen_from_top(next());
        sums.add(p, q, r);
        q = r;
      }
    }
    return {sums, {top.x, top.y, top.z}};
  }

  /// Sums over the owner's cells. False when they are other ones now.
  bool divide(int owner, double volume, FieldForce<3>& sum) {
    const Quad* const planes = planes_ + (owner == 0 ? 0 : face_count_[0]);
    const int count = find_cells_corners();
    sound(planes, face_count_[owner], count);
    if (!(shallowest_ >= -rounding_) || !corners_are_where_they_were() || comes_near_others(owner))
      return false;
    for (int cells = next(); cells > 0; --cells) {
      const Quad& p = planes[next()];
      const auto [sums, top] = sum_up<VolumeSums>();
      const auto [cell, moment] = sums.with_origin_at(top);
      const Vector<3> normal(p.x, p.y, p.z);
      sum.add_cell(cell, moment, p.w * cell - normal.dot(moment), normal);
      volume -= cell;
    }
    const Vector<3>& h = half_size_;
    return std::abs(volume) <= 4 * rounding_ * (h.x() * h.y() + h.y() * h.z() + h.z() * h.x());
  }

  /// Returns how many there are together with the shared ones.
  int find_cells_corners() {
    int count = shared_count_;
    for (int n = next(); n > 0; --n, code_ += 6)
      corners_[count++] = meeting(difference(planes_[code_[0]], planes_[code_[1]]),
                                  difference(planes_[code_[2]], planes_[code_[3]]),
                                  difference(planes_[code_[4]], planes_[code_[5]]));
    return count;
  }

  /// How deep the corners are behind the owner's planes.
  void sound(const Quad* planes, int plane_count, int corner_count) {
    stride_ = plane_count + plane_count % 2;
    double nx[most_plan_faces], ny[most_plan_faces], nz[most_plan_faces], offset[most_plan_faces];
    for (int k = 0; k < stride_; ++k) {
      const Quad& p = planes[std::min(k, plane_count - 1)];
      nx[k] = p.x;
      ny[k] = p.y;
      nz[k] = p.z;
      offset[k] = p.w;
    }
    shallowest_ = HUGE_VAL;
    deepest_ = -HUGE_VAL;
    double* row = depth_;
    for (int c = 0; c < corner_count; ++c, row += stride_) {
      const TwoLanes x = both(corners_[c].x), y = both(corners_[c].y), z = both(corners_[c].z);
      TwoLanes least = both(HUGE_VAL);
      for (int k = 0; k < stride_; k += 2) {
        const TwoLanes height = two_at(nx + k) * x + two_at(ny + k) * y + two_at(nz + k) * z;
        const TwoLanes depth = two_at(offset + k) - height;
        put_two_at(row + k, depth);
        least = smaller(least, depth);
      }
      least_depth_[c] = std::min(least[0], least[1]);
      shallowest_ = std::min(shallowest_, least_depth_[c]);
      deepest_ = std::max(deepest_, least_depth_[c]);
    }
  }

  /// Each nearest to the same faces and on the same ones. No corner that is not a number is.
  bool corners_are_where_they_were() {
    bool all = true;
    for (int n = next(); n > 0; --n, code_ += 2)
      all &= depth_[code_[0] * stride_ + code_[1]] <= least_depth_[code_[0]] + rounding_;
    for (int n = next(); n > 0; --n, code_ += 2) all &= depth_[code_[0] * stride_ + code_[1]] <= rounding_;
    return all;
  }

  /// Whether, by the bounds of what the blocks have in common, a face that did not matter may do so now.
  bool comes_near_others(int owner) const {
    std::uint64_t matters[most_faces_to_plan / 64] = {};
    for (int f = 0; f < face_count_[owner]; ++f)
      matters[faces_[owner][f] / 64] |= std::uint64_t(1) << faces_[owner][f] % 64;
    const Outline<3>& o = blocks_[owner].outline;
    const Vector<3> center = center_ - blocks_[owner].at;
    const TwoLanes cx = both(center.x()), cy = both(center.y()), cz = both(center.z());
    const TwoLanes hx = both(half_size_.x()), hy = both(half_size_.y()), hz = both(half_size_.z());
    const TwoLanes deepest = both(deepest_);
    unsigned near = 0;
    for (int f = 0; f < o.face_count(); f += 2) {
      const TwoLanes nx = two_at(o.nx + f), ny = two_at(o.ny + f), nz = two_at(o.nz + f);
      const TwoLanes depth = two_at(o.offset + f) - (nx * cx + ny * cy + nz * cz);
      const TwoLanes spread = magnitude(nx) * hx + magnitude(ny) * hy + magnitude(nz) * hz;
      // What lies behind an odd last face repeats it.
      near |= signs(depth - spread - deepest) & ~unsigned(matters[f / 64] >> f % 64) &
              (f + 1 < o.face_count() ? 3 : 1);
    }
    return near != 0;
  }

  const PlanCode* code_;
  PlacedBlock blocks_[2];
  const PlanCode* faces_[2];
  int face_count_[2];
  int shared_count_ = 0;
  Vector<3> center_, half_size_;  // of what the blocks have in common
  double rounding_ = 0;
  double shallowest_, deepest_;
  int stride_ = 0;
  Quad planes_[2 * most_plan_faces + 1];
  Quad corners_[most_plan_corners];
  double least_depth_[most_plan_corners];
  double depth_[most_plan_corners * most_plan_faces];
};

}  // namespace

std::optional<PotentialForce<3>> follow(std::span<const PlanCode> plan, const Outline<3>& a,
                                        const Outline<3>& b, const Vector<3>& to_b) {
  return Follower(plan.data(), a, b, to_b).force();
}

}  // namespace halfspace
