#include "detection.h"
#include "guard.h"
#include "narrow_phase/plane/posed_pair.h"
#include "pair_arguments.h"
#include "sized_struct.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_pair_options default_definition() {
  const PairOptions defaults;
  return {0, 0, defaults.parallel_angle, defaults.vertex_zone, defaults.margin, 0, 0};
}

DetectOptions read_detect_options(double parallel_angle, double vertex_zone) {
  require(parallel_angle >= 0 && parallel_angle <= 0.5, parallel_angle, "parallel_angle",
          "from 0 to 0.5 rad");
  require(vertex_zone >= 0 && vertex_zone <= 0.5, vertex_zone, "vertex_zone", "from 0 to 0.5");
  return {parallel_angle, vertex_zone};
}

PairOptions read_options(const hs_pair_options* options) {
  if (!options) return {};
  const hs_pair_options known = read_definition(options, "options");
  require(known.margin >= 0 && is_within_limits(known.margin), known.margin, "margin", "from 0 to 1e75");
  require(known.without_region == 0 || known.without_region == 1, known.without_region, "without_region",
          "0 or 1");
  return {read_detect_options(known.parallel_angle, known.vertex_zone), known.margin,
          known.without_region == 0};
}

void require_for(int dimension, const PairOptions& options) {
  if (dimension == 2) return;
  require(options.margin == 0, options.margin, "margin", "0 for polyhedra");
  require(options.with_region, 1, "without_region", "0 for polyhedra");
}

namespace {

/// hs_pair_detect() without a valid separation proof. It is a function of its own, so that a call with a
/// valid proof stays cheap.
[[gnu::noinline]] hs_status detect_guarded(const hs_shape* shape_a, const hs_pose* pose_a,
                                           const hs_shape* shape_b, const hs_pose* pose_b,
                                           const hs_pair_options* options, hs_pair_cache* cache,
                                           hs_contact* contact) {
  hs_context* context = context_of(shape_a ? shape_a : shape_b);
  return guarded_in_arithmetic_of_host(context, "hs_pair_detect", [&] {
    require_pointer(shape_a, "shape_a");
    require_pointer(shape_b, "shape_b");
    require_pointer(pose_a, "pose_a");
    require_pointer(pose_b, "pose_b");
    require_pointer(contact, "contact");
    require_one_dimension(*shape_a, "shape_a", *shape_b, "shape_b");
    const PairOptions known = read_options(options);
    require_for(shape_a->dimension(), known);
    visit(*shape_a, *pose_a, *shape_b, *pose_b,
          [&](const auto& posed) { detect(posed, known, cache, &context->memory, *contact); });
    return HS_OK;
  });
}

/// Describes the contact of blocks for which detect_cold() has found an overlap. Its results are passed in
/// registers.
[[gnu::noinline]] hs_status describe_guarded(const hs_shape& a, const hs_pose& at_a, const hs_shape& b,
                                             const hs_pose& at_b, int owner, int edge, hs_contact& out,
                                             Rotation<2> b_in_a, TwoLanes to_b, Rotation<2> frame_of_a) {
  return guarded_in_arithmetic_of_host(a.context, "hs_pair_detect", [&] {
    const TurnedPolygon turned(as<2>(b).outline(), b_in_a, &a.context->memory);
    PairCache<2> witness;
    write_contact(describe_overlap(posed_as<2>(a, at_a, b, at_b), turned.outline(), {to_b[0], to_b[1]},
                                   frame_of_a, {owner, edge, 0}, DetectOptions(), witness),
                  out);
    return HS_OK;
  });
}

/// hs_pair_detect() without cache and options, for polygons within max_combinations. The path of separated
/// polygons needs no guard, as nothing on it throws.
template <int max_vertices>
[[gnu::always_inline]] inline hs_status detect_cold(const hs_shape& a, const hs_pose& at_a, const hs_shape& b,
                                                    const hs_pose& at_b, hs_contact* contact) {
  const PosedPair<2> posed = posed_as<2>(a, at_a, b, at_b);
  if (!are_tolerable<2>(posed.at_a, posed.at_b))
    return detect_guarded(&a, &at_a, &b, &at_b, nullptr, nullptr, contact);
  const Frames<2> frames = frames_of<2>(posed.at_a, posed.at_b);
  const Separation<2> found = find_separation_of_few<max_vertices>(posed, frames.seen);
  if (found.gap > 0) {
    write_contact(contact_at(found, ContactType::none, posed, frames.turns), *contact);
    return HS_OK;
  }
  const Vector<2> to_b = frames.to_b();
  return describe_guarded(a, at_a, b, at_b, found.pair.owner, found.pair.edge, *contact, frames.b_in_a(),
                          TwoLanes{to_b.x(), to_b.y()}, frames.of_a());
}

/// Likewise, not inlined: the call is cheap compared with the vertices.
template <int max_vertices>
[[gnu::noinline]] hs_status detect_cold_by_call(const hs_shape& a, const hs_pose& at_a, const hs_shape& b,
                                                const hs_pose& at_b, hs_contact* contact) {
  return detect_cold<max_vertices>(a, at_a, b, at_b, contact);
}

/// hs_pair_detect() with a cache and without options, unless both shapes are polygons. It is a function of
/// its own, so that polygons need not save its registers.
[[gnu::noinline]] hs_status detect_in_space(const hs_shape* shape_a, const hs_pose* pose_a,
                                            const hs_shape* shape_b, const hs_pose* pose_b,
                                            hs_pair_cache* cache, hs_contact* contact) {
  if (shape_a->dimension() == 3 && shape_b->dimension() == 3 &&
      answer_by_proof(posed_as<3>(*shape_a, *pose_a, *shape_b, *pose_b), *cache, *contact))
    return HS_OK;
  return detect_guarded(shape_a, pose_a, shape_b, pose_b, nullptr, cache, contact);
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_pair_options_init(hs_pair_options* options, size_t size) {
  return write_definition(options, size);
}

hs_status hs_pair_detect(const hs_shape* shape_a, const hs_pose* pose_a, const hs_shape* shape_b,
                         const hs_pose* pose_b, const hs_pair_options* options, hs_pair_cache* cache,
                         hs_contact* contact) {
  if (!options && shape_a && pose_a && shape_b && pose_b && contact) {
    const std::int64_t m = shape_a->polygon_vertices, n = shape_b->polygon_vertices;
    if (cache) {
      if (shape_a->dimension() == 3 || shape_b->dimension() == 3)
        return detect_in_space(shape_a, pose_a, shape_b, pose_b, cache, contact);
      if (answer_by_proof(posed_as<2>(*shape_a, *pose_a, *shape_b, *pose_b), *cache, *contact)) return HS_OK;
    } else if (m == 3 && n == 3) {
      return detect_cold<3>(*shape_a, *pose_a, *shape_b, *pose_b, contact);
    } else if (m <= 4 && n <= 4) {
      return detect_cold_by_call<4>(*shape_a, *pose_a, *shape_b, *pose_b, contact);
    } else if (m * n <= max_combinations) {
      return detect_cold_by_call<max_combinations>(*shape_a, *pose_a, *shape_b, *pose_b, contact);
    }
  }
  return detect_guarded(shape_a, pose_a, shape_b, pose_b, options, cache, contact);
}
