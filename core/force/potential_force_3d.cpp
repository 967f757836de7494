#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "force/potential_force.h"
#include "geometry/two_lanes.h"

namespace halfspace {
namespace {

/// A block seen from the centroid of the one that is cut.
struct PlacedBlock {
  const Outline<3>& outline;
  Vector<3> at;

  CuttingPlane plane(int face) const {
    const Vector<3> normal = outline.normal(face);
    return {normal, outline.offset[face] + normal.dot(at)};
  }
};

/// The face that a point lies least deep behind.
int face_nearest_to(const Outline<3>& block, const Vector<3>& p) {
  const TwoLanes x = both(p.x()), y = both(p.y()), z = both(p.z());
  TwoLanes least = both(HUGE_VAL), nearest{}, face{0, 1};
  for (int f = 0; f < block.face_count(); f += 2) {
    const TwoLanes height = two_at(block.nx + f) * x + two_at(block.ny + f) * y + two_at(block.nz + f) * z;
    const TwoLanes depth = two_at(block.offset + f) - height;
    nearest = depth < least ? face : nearest;
    least = smaller(least, depth);
    face += both(2);
  }
  // The last face may have been looked at twice.
  return std::min(int(least[1] < least[0] ? nearest[1] : nearest[0]), block.face_count() - 1);
}

/// What a piece lies within: cheap to compare with a plane.
struct Bounds {
  explicit Bounds(const PolyhedronView& piece) {
    const double* coordinates[] = {piece.x, piece.y, piece.z};
    for (int k = 0; k < 3; ++k) {
      TwoLanes lower = two_at(coordinates[k]), upper = lower;
      for (int v = 2; v < piece.vertex_count; v += 2) {
        lower = smaller(lower, two_at(coordinates[k] + v));
        upper = larger(upper, two_at(coordinates[k] + v));
      }
      const double least = std::min(lower[0], lower[1]), most = std::max(upper[0], upper[1]);
      center[k] = 0.5 * (least + most);
      half_size[k] = most - center[k];
    }
  }

  Vector<3> center;
  Vector<3> half_size;
};

/// What one block's potential does to the other one, and in return to its owner.
struct FieldForce {
  Vector<3> force = Vector<3>::Zero();  // on the other block
  Tensor<3> virial_of_owner = Tensor<3>::Zero();
  Tensor<3> virial_of_other = Tensor<3>::Zero();
  double energy = 0;
};

/// What a block, the whole, has in common with another, the cutter.
class Intersection {
 public:
  Intersection(const PlacedBlock& whole, const PlacedBlock& cutter, PotentialRoom<3>& room)
      : whole_(whole), cutter_(cutter), room_(room) {}

  /// `first` is the cutter's face to begin with. False when there is nothing.
  bool find(int first) {
    if (!cut(view_of(whole_.outline), cutter_.plane(first))) return false;
    find_least_depths(cutter_);
    for (int f = 0; f < cutter_.outline.face_count(); ++f) {
      if (f != first && room_.least_depth[std::size_t(f)] < 0 && !cut_again(cutter_.plane(f))) return false;
    }
    content_ = measure(room_.intersection.view());
    return content_.volume > 0;
  }

  const VolumeAndMoment& content() const { return content_; }

  FieldForce force_of(const PlacedBlock& owner) {
    const PlacedBlock& other = &owner == &whole_ ? cutter_ : whole_;
    find_near_faces(owner);
    const Vector<3> origin = find_cells(owner);
    FieldForce sum;
    Tensor<3> at_cells = Tensor<3>::Zero(), from_cells_to_feet = Tensor<3>::Zero();
    for (const NearFace& face : room_.near) {
      const auto& [normal, offset] = face.plane;
      const auto& [volume, moment] = face.cell;
      const double energy = offset * volume - normal.dot(moment);
      sum.force += volume * normal;
      sum.energy += energy;
      at_cells += normal * moment.transpose();
      from_cells_to_feet += energy * normal * normal.transpose();
    }
    sum.virial_of_owner = sum.force * (owner.at - origin).transpose() - at_cells - from_cells_to_feet;
    sum.virial_of_other =
        at_cells - sum.force * (other.at - origin).transpose() - sum.energy * Tensor<3>::Identity();
    return sum;
  }

 private:
  bool cut(const PolyhedronView& piece, const CuttingPlane& plane) {
    if (room_.sounding.take(piece, plane).most <= 0) return false;
    keep_inside(piece);
    return true;
  }

  bool cut_again(const CuttingPlane& plane) {
    const DepthRange depths = room_.sounding.take(room_.intersection.view(), plane);
    if (depths.most <= 0) return false;
    if (depths.least < 0) keep_inside(room_.intersection.view());
    return true;
  }

  void keep_inside(const PolyhedronView& piece) {
    room_.cutter.keep_inside(piece, room_.sounding, room_.cut);
    std::swap(room_.intersection, room_.cut);
  }

  /// How deep the intersection is behind each face, by its bounds: no less. Behind one of them all of it is
  /// no deeper than what is returned.
  double find_least_depths(const PlacedBlock& owner) {
    const Outline<3>& o = owner.outline;
    const Bounds bounds(room_.intersection.view());
    const Vector<3> center = bounds.center - owner.at;
    const std::size_t count = std::size_t(Outline<3>::padded(o.face_count()));
    if (room_.least_depth.size() < count) room_.least_depth.resize(count);
    TwoLanes reach = both(HUGE_VAL);
    for (std::size_t f = 0; f < count; f += 2) {
      const TwoLanes nx = two_at(o.nx + f), ny = two_at(o.ny + f), nz = two_at(o.nz + f);
      const TwoLanes height = nx * both(center.x()) + ny * both(center.y()) + nz * both(center.z());
      const TwoLanes depth = two_at(o.offset + f) - height;
      const TwoLanes spread = magnitude(nx) * both(bounds.half_size.x()) +
                              magnitude(ny) * both(bounds.half_size.y()) +
                              magnitude(nz) * both(bounds.half_size.z());
      put_two_at(room_.least_depth.data() + f, depth - spread);
      reach = smaller(reach, depth + spread);
    }
    return std::min(reach[0], reach[1]);
  }

  /// No point of the intersection is deeper in the owner than, of all faces, behind the one that it reaches
  /// least deep behind. A face that all of it is deeper behind is nowhere the nearest. The faces that are so
  /// for most of it come first: then it is divided into the fewest parts.
  void find_near_faces(const PlacedBlock& owner) {
    double reach = find_least_depths(owner);
    const PolyhedronView intersection = room_.intersection.view();
    room_.near.clear();
    for (int f = 0; f < owner.outline.face_count(); ++f) {
      if (room_.least_depth[std::size_t(f)] > reach) continue;
      const CuttingPlane plane = owner.plane(f);
      const DepthRange depths = room_.sounding.take(intersection, plane);
      reach = std::min(reach, depths.most);
      room_.near.push_back({f, plane, depths, {}});
    }
    std::erase_if(room_.near, [&](const NearFace& face) { return face.depths.least > reach; });
    std::sort(room_.near.begin(), room_.near.end(), [](const NearFace& e, const NearFace& f) {
      return e.depths.least + e.depths.most < f.depths.least + f.depths.most;
    });
  }

  /// Returns from where the near faces' planes and cells are seen.
  Vector<3> find_cells(const PlacedBlock& owner) {
    if (room_.near.size() == 1) {
      room_.near[0].cell = content_;
      return Vector<3>::Zero();
    }
    const std::optional<Vector<3>> top = common_point(owner);
    if (top) {
      find_cones(owner, *top);
      return *top;
    }
    room_.solid_cells.divide(room_.intersection.view(), content_, room_.near, room_.sounding);
    return Vector<3>::Zero();
  }

  /// Of all near faces: a vertex or, on an edge, the point next to the intersection, so that no digits are
  /// lost far from there.
  std::optional<Vector<3>> common_point(const PlacedBlock& owner) const {
    const Outline<3>& o = owner.outline;
    const Topology& t = *o.topology;
    const auto is_common = [&](std::int32_t vertex) {
      return std::all_of(room_.near.begin() + 1, room_.near.end(), [&](const NearFace& near) {
        const std::int32_t *first = t.face_vertex + t.first_of_face[near.face],
                           *end = t.face_vertex + t.first_of_face[near.face + 1];
        return std::find(first, end, vertex) != end;
      });
    };
    const std::int32_t *first = t.face_vertex + t.first_of_face[room_.near[0].face],
                       *end = t.face_vertex + t.first_of_face[room_.near[0].face + 1];
    const std::int32_t* vertex = std::find_if(first, end, is_common);
    if (vertex == end) return {};
    const Vector<3> point = o.vertex(*vertex) + owner.at;
    const std::int32_t* other = std::find_if(vertex + 1, end, is_common);
    if (other == end) return point;
    const Vector<3> along = o.vertex(*other) - o.vertex(*vertex);
    const PolyhedronView intersection = room_.intersection.view();
    const Vector<3> way = Vector<3>(intersection.x[0], intersection.y[0], intersection.z[0]) - point;
    return point + along.dot(way) / along.squaredNorm() * along;
  }

  /// Where all near faces meet, all planes between them do, and the cells are cones from there: over those
  /// faces of the intersection that are of the other block, as the owner's are near ones. It is enough to
  /// divide these.
  void find_cones(const PlacedBlock& owner, const Vector<3>& top) {
    for (NearFace& near : room_.near) near.plane.offset = 0;
    const PolyhedronView intersection = room_.intersection.view();
    const bool owner_is_whole = &owner == &whole_;
    const int begin = owner_is_whole ? intersection.old_face_count : 0,
              end = owner_is_whole ? intersection.face_count : intersection.old_face_count;
    for (int face = begin; face < end; ++face) {
      const std::int32_t first = intersection.first_of_face[face],
                         last = intersection.first_of_face[face + 1];
      PieceVertices& base = room_.base.vertices();
      base.begin(std::size_t(last - first));
      for (std::int32_t k = first; k < last; ++k) {
        const std::int32_t v = intersection.corner[k];
        base.add(intersection.x[v] - top.x(), intersection.y[v] - top.y(), intersection.z[v] - top.z());
      }
      base.end();
      const PolygonView polygon = room_.base.view();
      room_.cone_cells.divide(polygon, measure(polygon), room_.near, room_.sounding);
    }
  }

  const PlacedBlock& whole_;
  const PlacedBlock& cutter_;
  PotentialRoom<3>& room_;
  VolumeAndMoment content_;
};

}  // namespace

/// The block is cut that the other reaches into less: that leaves less to cut.
PotentialForce<3> potential_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                  PotentialRoom<3>& room) {
  const int of_a = face_nearest_to(a, to_b), of_b = face_nearest_to(b, -to_b);
  const double into_a = room.sounding.take(view_of(b), PlacedBlock{a, -to_b}.plane(of_a)).most,
               into_b = room.sounding.take(view_of(a), PlacedBlock{b, to_b}.plane(of_b)).most;
  const bool cuts_b = into_a <= into_b;
  const PlacedBlock placed_a{a, cuts_b ? Vector<3>(-to_b) : Vector<3>::Zero()},
      placed_b{b, cuts_b ? Vector<3>::Zero() : to_b};
  Intersection intersection(cuts_b ? placed_b : placed_a, cuts_b ? placed_a : placed_b, room);
  if (!intersection.find(cuts_b ? of_a : of_b)) return {};
  const auto& [volume, moment] = intersection.content();
  const FieldForce by_a = intersection.force_of(placed_a), by_b = intersection.force_of(placed_b);
  return {by_a.force - by_b.force,
          by_a.virial_of_owner + by_b.virial_of_other,
          by_a.virial_of_other + by_b.virial_of_owner,
          moment / volume - placed_a.at,
          volume,
          by_a.energy + by_b.energy};
}

}  // namespace halfspace
