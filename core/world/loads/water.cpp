#include "world/loads/water.h"

#include <array>

// A face is divided into simplices: segments in the plane, triangles in space. Each is clipped at the sides
// of a part of the table and at the table itself. What is left is convex, the depth is linear on it, and the
// integrals of the depth, of its moment and of its square have a closed form on simplices.

namespace halfspace {
namespace {

/// A convex part of a face: an oriented segment or a polygon, counter-clockwise seen from outside, with arms
/// from the centroid of the block.
template <int D>
struct Patch {
  // A triangle gains at most one corner at each of six planes: four sides and the diagonal of a cell of a
  // height map, and the table.
  static constexpr int max_corners = D == 2 ? 2 : 9;

  /// Keeps the part on which a linear function is at least 0; values[i] is its value at corner i.
  void clip(const std::array<double, max_corners>& values);

  int count = 0;
  std::array<Vector<D>, max_corners> corner;
};

template <int D>
Vector<D> crossing(const Vector<D>& a, double value_a, const Vector<D>& b, double value_b) {
  return a + (value_a / (value_a - value_b)) * (b - a);
}

template <>
void Patch<2>::clip(const std::array<double, 2>& values) {
  if (values[0] < 0 && values[1] < 0) count = 0;
  if (count == 0 || (values[0] >= 0 && values[1] >= 0)) return;
  corner[values[0] < 0 ? 0 : 1] = crossing<2>(corner[0], values[0], corner[1], values[1]);
}

template <>
void Patch<3>::clip(const std::array<double, max_corners>& values) {
  Patch<3> kept;
  for (int i = 0; i < count; ++i) {
    const std::size_t here = std::size_t(i), next = std::size_t(i + 1 < count ? i + 1 : 0);
    if (values[here] >= 0) kept.corner[std::size_t(kept.count++)] = corner[here];
    if ((values[here] >= 0) != (values[next] >= 0)) {
      kept.corner[std::size_t(kept.count++)] =
          crossing<3>(corner[here], values[here], corner[next], values[next]);
    }
  }
  *this = kept;
}

template <int D, class ValueAt>
void clip_where(Patch<D>& patch, ValueAt value_at) {
  std::array<double, Patch<D>::max_corners> values{};
  for (std::size_t i = 0; i < std::size_t(patch.count); ++i) values[i] = value_at(patch.corner[i]);
  patch.clip(values);
}

/// The area of a simplex times its outer normal.
Vector<2> area_vector(const std::array<Vector<2>, 2>& corner) {
  return -perpendicular(corner[1] - corner[0]);
}
Vector<3> area_vector(const std::array<Vector<3>, 3>& corner) {
  return 0.5 * cross_product(corner[1] - corner[0], corner[2] - corner[0]);
}

/// Adds the load of a linear depth on a simplex, for a unit weight of 1.
template <int D>
void add_simplex(const std::array<Vector<D>, D>& corner, const std::array<double, D>& depth,
                 WaterLoad<D>& load) {
  const Vector<D> area = area_vector(corner);
  double sum = 0, squares = 0;
  Vector<D> arms = Vector<D>::Zero(), moments = Vector<D>::Zero();
  for (std::size_t i = 0; i < D; ++i) {
    sum += depth[i];
    squares += depth[i] * depth[i];
    arms += corner[i];
    moments += depth[i] * corner[i];
  }
  constexpr double first = 1.0 / D, second = 1.0 / (D * (D + 1));
  load.force -= first * sum * area;
  load.virial -= area * (second * (moments + sum * arms)).transpose();
  // The pressure is the vertical derivative of minus half the squared depth: by the divergence theorem the
  // flux of that through the surface is the integral over the volume.
  load.energy -= 0.5 * area[D - 1] * second * (sum * sum + squares);
}

template <int D>
class Faces {
 public:
  Faces(const WaterTable<D>& table, const Vector<D>& centroid) : table_(table), centroid_(centroid) {}

  void add(const std::array<Vector<D>, D>& corner) {
    Vector<D> from = centroid_ + corner[0], to = from;
    for (const Vector<D>& arm : corner) {
      from = from.cwiseMin(centroid_ + arm);
      to = to.cwiseMax(centroid_ + arm);
    }
    table_.for_each_part(from, to, [&](const WaterPart<D>& part) {
      Patch<D> patch;
      patch.count = D;
      std::copy(corner.begin(), corner.end(), patch.corner.begin());
      for (int k = 0; k < D - 1; ++k) {
        if (from[k] < part.low[k])
          clip_where(patch, [&](const Vector<D>& arm) { return centroid_[k] + arm[k] - part.low[k]; });
        if (to[k] > part.high[k])
          clip_where(patch, [&](const Vector<D>& arm) { return part.high[k] - centroid_[k] - arm[k]; });
      }
      if (part.is_half) {
        clip_where(patch, [&](const Vector<D>& arm) {
          return part.side.dot(centroid_ + arm - part.depth.on_table);
        });
      }
      add_wet(patch, part.depth);
    });
  }
  const WaterLoad<D>& load() const { return load_; }

 private:
  void add_wet(Patch<D>& patch, const WaterDepth<D>& depth) {
    const auto depth_at = [&](const Vector<D>& arm) { return depth.at(centroid_ + arm); };
    clip_where(patch, depth_at);
    const auto wet_depth_at = [&](const Vector<D>& arm) { return std::max(depth_at(arm), 0.0); };
    for (std::size_t i = 1; i + (D - 1) <= std::size_t(patch.count); ++i) {
      std::array<Vector<D>, D> corner;
      std::array<double, D> depths;
      for (std::size_t k = 0; k < D; ++k) {
        corner[k] = patch.corner[k == 0 ? 0 : i + k - 1];
        depths[k] = wet_depth_at(corner[k]);
      }
      add_simplex<D>(corner, depths, load_);
    }
  }

  const WaterTable<D>& table_;
  const Vector<D>& centroid_;
  WaterLoad<D> load_;
};

void add_all(const Outline<2>& outline, Faces<2>& faces) {
  for (int i = 0; i < outline.count; ++i) faces.add({outline.vertex(i), outline.vertex(outline.next(i))});
}

void add_all(const Outline<3>& outline, Faces<3>& faces) {
  const Topology& topology = *outline.topology;
  for (int f = 0; f < topology.face_count; ++f) {
    const int first = topology.first_of_face[f], past = topology.first_of_face[f + 1];
    const auto corner = [&](int k) { return outline.vertex(topology.face_vertex[k]); };
    for (int k = first + 1; k + 1 < past; ++k) faces.add({corner(first), corner(k), corner(k + 1)});
  }
}

/// The faces of a cell that are at the surface of its mesh.
template <int D>
void add_outer(const Meshes<D>& meshes, const SurfaceCell<D>& cell, Faces<D>& faces) {
  const Vector<D> middle = cell.mean_of(meshes.place);
  const auto arm = [&](std::size_t k) { return Vector<D>(meshes.place[std::size_t(cell.node[k])] - middle); };
  for (std::size_t opposite = 0; opposite <= D; ++opposite) {
    if (!(cell.outer_faces >> opposite & 1)) continue;
    std::array<Vector<D>, D> corner;
    for (std::size_t k = 0; k < D; ++k) corner[k] = arm(k < opposite ? k : k + 1);
    if (area_vector(corner).dot(arm(opposite) - corner[0]) > 0) std::swap(corner[0], corner[1]);
    faces.add(corner);
  }
}

}  // namespace

template <int D>
WaterLoad<D> Water<D>::load_on(const Blocks<D>& blocks, std::size_t slot, double unit_weight) const {
  Faces<D> faces(table_, blocks.position[slot]);
  if (blocks.is_of_mesh(slot)) {
    add_outer(blocks.meshes(), blocks.meshes().surface_of_block(slot), faces);
  } else {
    add_all(blocks.outline(std::int32_t(slot)), faces);
  }
  const WaterLoad<D>& load = faces.load();
  return {unit_weight * load.force, unit_weight * load.virial, unit_weight * load.energy};
}

template <int D>
double Water<D>::stiffness_on(const Blocks<D>& blocks, std::size_t slot, double unit_weight) const {
  const double surface = blocks.outline(std::int32_t(slot)).face_count() * blocks.largest_face[slot];
  return unit_weight * table_.steepest() * surface;
}

template class Water<2>;
template class Water<3>;

}  // namespace halfspace
