#include "force/potential/potential_force.h"

#include <algorithm>
#include <cmath>

#include "force/potential/field_force.h"
#include "force/potential/space/placed_block.h"
#include "geometry/tolerances.h"
#include "simd/two_lanes.h"

namespace halfspace {
namespace {

/// The face of minimum depth at a point.
int face_nearest_to(const Outline<3>& block, const Vector<3>& p) {
  const TwoLanes x = both(p.x()), y = both(p.y()), z = both(p.z());
  TwoLanes least = both(HUGE_VAL), nearest{}, face{0, 1};
  for (int f = 0; f < block.face_count(); f += 2) {
    const TwoLanes height =
        load_two(block.nx + f) * x + load_two(block.ny + f) * y + load_two(block.nz + f) * z;
    const TwoLanes depth = load_two(block.offset + f) - height;
    nearest = depth < least ? face : nearest;
    least = min(least, depth);
    face += both(2);
  }
  // The last face may have been tested twice.
  return std::min(int(least[1] < least[0] ? nearest[1] : nearest[0]), block.face_count() - 1);
}

/// Bounds of a polyhedron, for fast tests against a plane.
struct Bounds {
  Bounds() = default;
  explicit Bounds(const ClippedPolyhedron& body) {
    Vector<3> lower = body.position(body.vertices()[0]), upper = lower;
    for (const ClippedPolyhedron::Index v : body.vertices()) {
      lower = lower.cwiseMin(body.position(v));
      upper = upper.cwiseMax(body.position(v));
    }
    center = 0.5 * (lower + upper);
    half_size = upper - center;
  }

  double largest_coordinate() const { return (center.cwiseAbs() + half_size).maxCoeff(); }

  Vector<3> center;
  Vector<3> half_size;
};

/// The overlap of one block, the whole, with another, the cutter.
class Intersection {
 public:
  Intersection(const PlacedBlock& whole, const PlacedBlock& cutter, PotentialRoom<3>& room)
      : whole_(whole), cutter_(cutter), room_(room), near_(room.near) {}

  /// `first` is the cutter's first face, with the depths of the whole behind it. False when there is no
  /// overlap.
  bool find(int first, const VertexDepths& sounding) {
    room_.intersection.begin(whole_.outline, sounding);
    find_min_depths(cutter_, Bounds(room_.intersection));
    for (int f = 0; f < cutter_.outline.face_count(); ++f) {
      if (f != first && room_.min_depth[std::size_t(f)] < 0 && !cut(room_.intersection, cutter_.plane(f)))
        return false;
    }
    content_ = room_.intersection.measure_with_spread();
    bounds_ = Bounds(room_.intersection);
    near_.begin(room_.intersection);
    return content_.volume > 0;
  }

  const VolumeAndSpread& content() const { return content_; }

  /// The sum over the cells of an owner's near faces. Cells are small but for that of the first, which has
  /// the rest.
  FieldForce<3> force_by(const PlacedBlock& owner) {
    const double reach = find_min_depths(owner, bounds_);
    near_.find(owner, room_.min_depth.data(), reach);
    FieldForce<3> sum;
    if (near_.count() == 0) return sum;  // depths are NaN
    const double rounding = rounding_of_depths();
    VolumeAndMoment rest = content_;
    for (std::size_t k = 1; k < near_.count(); ++k) {
      const VolumeAndMoment cell = cell_of(k, rounding);
      rest.volume -= cell.volume;
      rest.moment -= cell.moment;
      add(near_[k], cell, sum);
    }
    add(near_[0], rest, sum);
    return sum;
  }

 private:
  /// Cuts a body by a plane unless all of it is behind. False where nothing is.
  static bool cut(ClippedPolyhedron& body, const Halfspace<3>& plane) {
    const DepthRange depths = body.sound(plane);
    if (depths.least < 0 && depths.most > 0) body.cut();
    return depths.most > 0;
  }

  static void add(const Halfspace<3>& face, const VolumeAndMoment& cell, FieldForce<3>& sum) {
    const double energy = face.offset * cell.volume - face.normal.dot(cell.moment);
    if (cell.volume != 0) sum.add_cell(cell.volume, cell.moment, energy, face.normal);
  }

  double rounding_of_depths() const {
    double largest = bounds_.largest_coordinate();
    for (std::size_t k = 0; k < near_.count(); ++k) largest = std::max(largest, std::abs(near_[k].offset));
    return place_rounding * largest;
  }

  /// The part of the intersection where a face is the nearest: behind the planes as near to it as to another.
  /// Where two are equally near, to rounding, the first of them has the cell.
  VolumeAndMoment cell_of(std::size_t k, double rounding) {
    room_.cell.begin(room_.intersection);
    for (const std::size_t other : near_.rivals_of(k)) {
      const double lead = other < k ? -rounding : rounding;
      const Halfspace<3> as_near{near_[other].normal - near_[k].normal,
                                 near_[other].offset - near_[k].offset + lead};
      if (!cut(room_.cell, as_near)) return {};
    }
    return room_.cell.measure();
  }

  /// Computes lower bounds of the intersection's depth behind each face, by its bounds. Returns an upper
  /// bound of its depth behind one of them.
  double find_min_depths(const PlacedBlock& owner, const Bounds& bounds) {
    const Outline<3>& o = owner.outline;
    const Vector<3> center = bounds.center - owner.at;
    const std::size_t count = std::size_t(Outline<3>::padded(o.face_count()));
    if (room_.min_depth.size() < count) room_.min_depth.resize(count);
    TwoLanes reach = both(HUGE_VAL);
    for (std::size_t f = 0; f < count; f += 2) {
      const TwoLanes nx = load_two(o.nx + f), ny = load_two(o.ny + f), nz = load_two(o.nz + f);
      const TwoLanes height = nx * both(center.x()) + ny * both(center.y()) + nz * both(center.z());
      const TwoLanes depth = load_two(o.offset + f) - height;
      const TwoLanes spread = abs(nx) * both(bounds.half_size.x()) + abs(ny) * both(bounds.half_size.y()) +
                              abs(nz) * both(bounds.half_size.z());
      store_two(room_.min_depth.data() + f, depth - spread);
      reach = min(reach, depth + spread);
    }
    return std::min(reach[0], reach[1]);
  }

  const PlacedBlock& whole_;
  const PlacedBlock& cutter_;
  PotentialRoom<3>& room_;
  NearFaces& near_;
  VolumeAndSpread content_;
  Bounds bounds_;
};

}  // namespace

/// Cuts the block that the other penetrates less: this leaves less to cut.
PotentialForce<3> potential_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                  PotentialRoom<3>& room) {
  const int of_a = face_nearest_to(a, to_b), of_b = face_nearest_to(b, -to_b);
  const double into_a = room.sounding_of_b.take(b, PlacedBlock{a, -to_b}.plane(of_a)).most;
  if (into_a <= 0) return {};
  const double into_b = room.sounding_of_a.take(a, PlacedBlock{b, to_b}.plane(of_b)).most;
  if (into_b <= 0) return {};
  const bool cuts_b = into_a <= into_b;
  const PlacedBlock placed_a{a, cuts_b ? Vector<3>(-to_b) : Vector<3>::Zero()},
      placed_b{b, cuts_b ? Vector<3>::Zero() : to_b};
  Intersection intersection(cuts_b ? placed_b : placed_a, cuts_b ? placed_a : placed_b, room);
  if (!intersection.find(cuts_b ? of_a : of_b, cuts_b ? room.sounding_of_b : room.sounding_of_a)) return {};
  const VolumeAndSpread& content = intersection.content();
  const FieldForce<3> by_a = intersection.force_by(placed_a);
  const FieldForce<3> by_b = intersection.force_by(placed_b);
  PotentialForce<3> sum = sum_of<3>(by_a, by_b, placed_a.at, placed_b.at,
                                    content.moment / content.volume - placed_a.at, content.volume);
  sum.spread = content.spread;
  return sum;
}

}  // namespace halfspace
