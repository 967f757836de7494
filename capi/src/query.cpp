#include "halfspace/query.h"

#include "broad_phase/grid.h"
#include "broad_phase/hilbert_curve.h"
#include "geometry/unit_vector.h"
#include "narrow_phase/closest_points.h"
#include "narrow_phase/ray.h"
#include "pair_arguments.h"
#include "strided_view.h"
#include "world/ray_cast.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// Boxes and points have 32-bit indices.
constexpr int bits_of_indices = 30;

template <int D>
Ray<D> read_ray(const double* origin, const double* direction, double max_distance) {
  const Vector<D> start = read_finite_vector<D>(origin, "origin"),
                  along = read_finite_vector<D>(direction, "direction");
  if (along.isZero(0))
    refuse(HS_ERROR_ARGUMENT, "direction is %s; it must not be 0", PointText(along).characters);
  return {start, unit_vector<D>(along), require_from_zero(max_distance, "max_distance")};
}

/// `normal_of(face)`: in the host's orientation.
template <int D, class Normal>
hs_ray_hit hit_of(const Ray<D>& ray, const RayHit& at, hs_block block, Normal&& normal_of) {
  hs_ray_hit hit{1, at.face, block, at.distance, {}, {}};
  write_vector(ray.origin + at.distance * ray.direction, hit.point);
  if (at.face >= 0) write_vector(normal_of(at.face), hit.normal);
  return hit;
}

constexpr hs_ray_hit no_hit{0, -1, 0, 0, {}, {}};

template <int D>
Box<D> read_box(const hs_view& lower, const hs_view& upper, std::int64_t i) {
  const Box<D> box{read_finite_point<D>(lower, i, "lower"), read_finite_point<D>(upper, i, "upper")};
  if ((box.lower.array() <= box.upper.array()).all()) return box;
  refuse(HS_ERROR_ARGUMENT, "lower[%lld] is %s and upper[%lld] %s; no component may be above the upper one",
         static_cast<long long>(i), PointText(box.lower).characters, static_cast<long long>(i),
         PointText(box.upper).characters);
}

template <int D>
hs_status find_pairs(hs_context* context, const hs_view& lower, const hs_view& upper, std::int32_t* pairs,
                     std::int64_t capacity, std::int64_t* count) {
  require_view<D>(lower, "lower");
  require_view<D>(upper, "upper");
  Array<Box<D>> boxes(&context->memory);
  boxes.reserve(std::size_t(lower.count));
  for (std::int64_t i = 0; i < lower.count; ++i) boxes.push_back(read_box<D>(lower, upper, i));
  std::int64_t found = 0;
  Grid<D> grid(&context->memory);
  grid.search(
      boxes, [](std::size_t) { return true; },
      [&](const BlockPair& pair) {
        if (found < capacity) {
          pairs[2 * found] = pair.a;
          pairs[2 * found + 1] = pair.b;
        }
        ++found;
      });
  if (count) *count = found;
  return fits(found, capacity);
}

template <int D>
void order_points(hs_context* context, const hs_view& points, std::int32_t* order) {
  const Array<Vector<D>> read = read_finite_points<D>(context, points, "points");
  if (!read.empty()) require_pointer(order, "order");
  order_along_curve<D>(read, {order, read.size()}, &context->memory);
}

}  // namespace

hs_status hs_shape_cast_ray(const hs_shape* shape, const hs_pose* pose, const double origin[3],
                            const double direction[3], double max_distance, hs_ray_hit* hit) {
  return with_shape(shape, __func__, [&]<int D>(const Shape<D>& s) {
    const Pose<D> at = read_pose<D>(pose, "pose");
    const Ray<D> ray = read_ray<D>(origin, direction, max_distance);
    require_pointer(hit, "hit");
    const Rotation<D> into_shape = at.rotation.inverse();
    const Ray<D> seen{into_shape * Vector<D>(ray.origin - at.position), into_shape * ray.direction,
                      ray.length};
    RayHit first{ray.length};
    *hit = meets(seen, s.outline(), first)
               ? hit_of(ray, first, 0, [&](int face) { return at.rotation * s.outline().normal(face); })
               : no_hit;
    return HS_OK;
  });
}

hs_status hs_world_cast_ray(const hs_world* world, const double origin[3], const double direction[3],
                            double max_distance, hs_ray_hit* hit) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    const Ray<D> ray = read_ray<D>(origin, direction, max_distance);
    require_pointer(hit, "hit");
    const BlockHit first = first_block_on(ray, w.blocks());
    *hit = first.slot < 0 ? no_hit
                          : hit_of(ray, first.at, id_of(w.blocks(), std::size_t(first.slot)),
                                   [&](int face) { return w.blocks().outline(first.slot).normal(face); });
    return HS_OK;
  });
}

hs_status hs_pair_distance(const hs_shape* shape_a, const hs_pose* pose_a, const hs_shape* shape_b,
                           const hs_pose* pose_b, hs_closest_points* points) {
  hs_context* context = context_of(shape_a ? shape_a : shape_b);
  return guarded(context, __func__, [&] {
    require_pointer(shape_a, "shape_a");
    require_pointer(shape_b, "shape_b");
    require_one_dimension(*shape_a, "shape_a", *shape_b, "shape_b");
    require_pointer(pose_a, "pose_a");
    require_pointer(pose_b, "pose_b");
    require_pointer(points, "points");
    return visit(*shape_a, *pose_a, *shape_b, *pose_b, [&]<int D>(const PosedPair<D>& posed) {
      require_pose<D>(posed.at_a, "pose_a");
      require_pose<D>(posed.at_b, "pose_b");
      const ClosestPoints<D> closest = find_closest_points(posed, &context->memory);
      const Vector<D> a = Vector<D>(posed.at_a.position);
      *points = {closest.distance, {}, {}, {}};
      write_vector(a + closest.on_a, points->point_a);
      write_vector(a + closest.on_b, points->point_b);
      write_vector(closest.normal, points->normal);
      return HS_OK;
    });
  });
}

hs_status hs_boxes_find_pairs(hs_context* context, int32_t dimension, hs_view lower, hs_view upper,
                              int32_t pairs[], int64_t capacity, int64_t* count) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require(dimension == 2 || dimension == 3, dimension, "dimension", "2 or 3");
    require_numbered(lower.count, "lower.count", bits_of_indices);
    if (upper.count != lower.count) {
      refuse(HS_ERROR_ARGUMENT, "upper.count is %lld; it must be lower.count, which is %lld",
             static_cast<long long>(upper.count), static_cast<long long>(lower.count));
    }
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(pairs, "pairs");
    return dimension == 2 ? find_pairs<2>(context, lower, upper, pairs, capacity, count)
                          : find_pairs<3>(context, lower, upper, pairs, capacity, count);
  });
}

hs_status hs_points_order_along_curve(hs_context* context, int32_t dimension, hs_view points,
                                      int32_t order[]) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require(dimension == 2 || dimension == 3, dimension, "dimension", "2 or 3");
    require_numbered(points.count, "points.count", bits_of_indices);
    if (dimension == 2) {
      order_points<2>(context, points, order);
    } else {
      order_points<3>(context, points, order);
    }
    return HS_OK;
  });
}
