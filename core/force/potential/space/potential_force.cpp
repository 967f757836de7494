#include "force/potential/potential_force.h"

#include <algorithm>
#include <cmath>

#include "force/potential/field_force.h"
#include "force/potential/space/placed_block.h"
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

/// Bounds of a part, for fast tests against a plane.
struct Bounds {
  Bounds() = default;
  Bounds(const DividedPolyhedron& parts, DividedPolyhedron::Part part) {
    Vector<3> lower = parts.position(part[0]), upper = lower;
    for (const DividedPolyhedron::Index v : part) {
      lower = lower.cwiseMin(parts.position(v));
      upper = upper.cwiseMax(parts.position(v));
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
      : whole_(whole), cutter_(cutter), room_(room) {}

  /// `first` is the cutter's first face, with the depths of the whole behind it. False when there is no
  /// overlap.
  bool find(int first, const VertexDepths& sounding) {
    room_.intersection.begin(whole_.outline, sounding, plane_of_cutter(first));
    take_inside();
    find_least_depths(cutter_, Bounds(room_.intersection, room_.vertices));
    for (int f = 0; f < cutter_.outline.face_count(); ++f) {
      if (f != first && room_.least_depth[std::size_t(f)] < 0 && !cut(f)) return false;
    }
    content_ = room_.intersection.measure(room_.vertices);
    bounds_ = Bounds(room_.intersection, room_.vertices);
    return content_.volume > 0;
  }

  const VolumeAndSpread& content() const { return content_; }

  /// By its bounds, no point of the intersection is deeper in the owner than this. A face behind which all of
  /// it is deeper is never the nearest.
  void find_near_faces(const PlacedBlock& owner, Array<NearFace>& near) {
    const double reach = find_least_depths(owner, bounds_);
    near.clear();
    for (int f = 0; f < owner.outline.face_count(); ++f) {
      const double least = room_.least_depth[std::size_t(f)];
      if (least <= reach) near.push_back({f, owner.plane(f), {least, reach}, {}});
    }
  }

  void put_down(DivisionRecord& record) const { record.add_corners(room_.intersection, room_.vertices); }

  FieldForce<3> force_by(Array<NearFace>& near, DivisionRecord* record) {
    const int block_faces = whole_.outline.face_count() + cutter_.outline.face_count();
    room_.cells.divide(room_.intersection, room_.vertices, content_, bounds_.largest_coordinate(),
                       DividedPolyhedron::Index(block_faces), near, record);
    FieldForce<3> sum;
    for (const NearFace& face : near) {
      const auto& [normal, offset] = face.plane;
      const auto& [volume, moment] = face.cell;
      if (volume != 0) sum.add_cell(volume, moment, offset * volume - normal.dot(moment), normal);
    }
    return sum;
  }

 private:
  DividedPolyhedron::Index plane_of_cutter(int face) const {
    return DividedPolyhedron::Index(whole_.outline.face_count() + face);
  }

  void take_inside() {
    const DividedPolyhedron::Part inside = room_.intersection.inside();
    room_.vertices.assign(inside.begin(), inside.end());
  }

  bool cut(int face) {
    const DepthRange depths = room_.intersection.sound(room_.vertices, cutter_.plane(face));
    if (depths.most <= 0) return false;
    if (depths.least < 0) {
      room_.intersection.cut_edges(room_.vertices);
      room_.intersection.close_inside(plane_of_cutter(face));
      take_inside();
    }
    return true;
  }

  /// Computes lower bounds of the intersection's depth behind each face, by its bounds. Returns an upper
  /// bound of its depth behind one of them.
  double find_least_depths(const PlacedBlock& owner, const Bounds& bounds) {
    const Outline<3>& o = owner.outline;
    const Vector<3> center = bounds.center - owner.at;
    const std::size_t count = std::size_t(Outline<3>::padded(o.face_count()));
    if (room_.least_depth.size() < count) room_.least_depth.resize(count);
    TwoLanes reach = both(HUGE_VAL);
    for (std::size_t f = 0; f < count; f += 2) {
      const TwoLanes nx = load_two(o.nx + f), ny = load_two(o.ny + f), nz = load_two(o.nz + f);
      const TwoLanes height = nx * both(center.x()) + ny * both(center.y()) + nz * both(center.z());
      const TwoLanes depth = load_two(o.offset + f) - height;
      const TwoLanes spread = abs(nx) * both(bounds.half_size.x()) + abs(ny) * both(bounds.half_size.y()) +
                              abs(nz) * both(bounds.half_size.z());
      store_two(room_.least_depth.data() + f, depth - spread);
      reach = min(reach, depth + spread);
    }
    return std::min(reach[0], reach[1]);
  }

  const PlacedBlock& whole_;
  const PlacedBlock& cutter_;
  PotentialRoom<3>& room_;
  VolumeAndSpread content_;
  Bounds bounds_;
};

}  // namespace

/// Cuts the block that the other penetrates less: this leaves less to cut.
PotentialForce<3> potential_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                  PotentialRoom<3>& room, DivisionRecord* record) {
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
  intersection.find_near_faces(placed_a, room.near_a);
  intersection.find_near_faces(placed_b, room.near_b);
  if (record) {
    record->begin(placed_a, placed_b, cuts_b ? 1 : 0, room.near_a, room.near_b);
    intersection.put_down(*record);
    record->divide_by(0);
  }
  const FieldForce<3> by_a = intersection.force_by(room.near_a, record);
  if (record) record->divide_by(1);
  const FieldForce<3> by_b = intersection.force_by(room.near_b, record);
  PotentialForce<3> sum = sum_of<3>(by_a, by_b, placed_a.at, placed_b.at,
                                    content.moment / content.volume - placed_a.at, content.volume);
  sum.spread = content.spread;
  return sum;
}

}  // namespace halfspace
