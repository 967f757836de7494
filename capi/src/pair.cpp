#include "pair.h"

#include "check.h"
#include "contact.h"
#include "detection.h"
#include "guard.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/plane/turned_outline.h"
#include "pair_cache.h"
#include "posed_pair.h"
#include "separation_proof.h"
#include "shape.h"

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

PairMemory<2> read_cache(const hs_pair_cache& cache, const Outline<2>& a, const Outline<2>& b) {
  require_state(cache);
  if (cache.state == PairMemory<2>::unknown) return {};
  require_kind(cache, NamedPair::vertex_face, "polygons");
  // A polygon has as many edges as vertices.
  require_index(cache.feature_a, a.count, "feature_a", "edges and as many vertices");
  require_index(cache.feature_b, b.count, "feature_b", "edges and as many vertices");
  return {PairMemory<2>::State(cache.state), in_plane(pair_in(cache))};
}

/// The cache may be NULL.
[[gnu::always_inline]] inline void answer_separated(const Separation<2>& separation,
                                                    const PosedPair<2>& posed, const Turns& turns,
                                                    hs_pair_cache* cache, hs_contact& out) {
  write_separation<2>(separation.pair, normal_from_a_to_b(separation.pair, posed, turns), separation.gap,
                      out);
  if (!cache) return;
  write_cache(PairMemory<2>::separated, named(separation.pair), *cache);
  keep_proof(posed, out, *cache);
}

/// A contact without its region: the pair of largest gap, whose vertex is looked for only now.
void answer_pair(const Separation<2>& largest, const PosedPair<2>& posed, const Placement<Turns>& at,
                 const Turns& turns, hs_pair_cache* cache, hs_contact& out) {
  PotentialPair<2> pair = largest.pair;
  const double gap = refresh(posed.a.shape.outline(), posed.b.shape.outline(), at, pair);
  write_pair<2>(ContactType::vertex_edge, 0, named(pair), normal_from_a_to_b(pair, posed, turns), gap, out);
  if (cache) write_cache(PairMemory<2>::unknown, named(pair), *cache);
}

void answer_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                    const Rotation<2>& rotation_of_a, const hs_pose& at_a,
                    const PotentialPair<2>& least_depth, const DetectOptions& options, PairMemory<2>& memory,
                    hs_pair_cache* cache, hs_contact& out) {
  Contact<2> contact;
  describe_overlap(a, b, to_b, least_depth, options, memory, contact);
  write_contact(contact, rotation_of_a, Vector<2>(at_a.position), out);
  if (cache) write_cache(memory.state, named(memory.pair), *cache);
}

}  // namespace

/// Each block in its own frame as long as that will do.
void judge(const PosedPair<2>& posed, const PairOptions& options, hs_pair_cache* cache, hs_contact& out) {
  const Turns turns = read_turns(posed.at_a, posed.at_b);
  const Placement<Turns> at = placement_of(turns, posed.at_a, posed.at_b);
  const Outline<2>& a = posed.a.shape.outline();
  const Outline<2>& b = posed.b.shape.outline();
  PairMemory<2> memory;
  if (cache) memory = read_cache(*cache, a, b);
  if (memory.state == PairMemory<2>::separated) {
    const double gap = refresh(a, b, at, memory.pair);
    if (gap > options.margin) return answer_separated({gap, memory.pair}, posed, turns, cache, out);
  }
  Separation<2> found;
  const bool by_all = by_all_combinations(a, b);
  if (by_all) {
    found = find_separation_by_all(a, b, at, options.margin);
    if (found.gap > options.margin) return answer_separated(found, posed, turns, cache, out);
    if (!options.with_region) return answer_pair(found, posed, at, turns, cache, out);
  }
  const Vector<2> to_b = only(at.to_other, 0);
  const Rotation<2> b_in_a = only(at.into_other, 1);
  const TurnedOutline turned(b, b_in_a, &posed.a.context->memory);
  if (!by_all) {
    found = find_separation_by_merge(a, turned.outline(), to_b, options.margin);
    if (found.gap > options.margin) return answer_separated(found, posed, turns, cache, out);
    if (!options.with_region) return answer_pair(found, posed, at, turns, cache, out);
  }
  answer_overlap(a, turned.outline(), to_b, only(turns, 0), posed.at_a, found.pair, options, memory, cache,
                 out);
}

void require_readable(const PosedPair<2>& posed, const hs_pair_cache* cache) {
  read_turns(posed.at_a, posed.at_b);
  if (cache) read_cache(*cache, posed.a.shape.outline(), posed.b.shape.outline());
}

namespace {

/// hs_pair_detect() when it takes more than the proof in the cache; apart from it, so that the proof is all
/// that is paid for there.
[[gnu::noinline]] hs_status detect_guarded(const hs_shape* shape_a, const hs_pose* pose_a,
                                           const hs_shape* shape_b, const hs_pose* pose_b,
                                           const hs_pair_options* options, hs_pair_cache* cache,
                                           hs_contact* contact) {
  hs_context* context = shape_a ? shape_a->context : shape_b ? shape_b->context : nullptr;
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
          [&](const auto& posed) { detect(posed, known, cache, *contact); });
    return HS_OK;
  });
}

/// The contact of blocks that detect_cold() has found to overlap. What it knows of the poses is handed over
/// in registers.
[[gnu::noinline]] hs_status describe_guarded(const ShapeHandle<2>& a, const hs_pose& at_a,
                                             const ShapeHandle<2>& b, int owner, int edge, hs_contact& out,
                                             Rotation<2> b_in_a, TwoLanes to_b, Rotation<2> rotation_of_a) {
  return guarded_in_arithmetic_of_host(a.context, "hs_pair_detect", [&] {
    const TurnedOutline turned(b.shape.outline(), b_in_a, &a.context->memory);
    PairMemory<2> memory;
    answer_overlap(a.shape.outline(), turned.outline(), {to_b[0], to_b[1]}, rotation_of_a, at_a,
                   {owner, edge, 0}, DetectOptions(), memory, nullptr, out);
    return HS_OK;
  });
}

/// hs_pair_detect() without cache and options, for blocks within most_combinations: the proof of separation
/// passes no guard, as nothing on its way throws. Compiled once more for few vertices, where the loops over
/// them come to an end that is known.
template <int most_vertices>
[[gnu::always_inline]] inline hs_status detect_cold(const PosedPair<2>& posed, hs_contact* contact) {
  const auto& [shape_a, pose_a, shape_b, pose_b] = posed;
  const Outline<2>& a = shape_a.shape.outline();
  const Outline<2>& b = shape_b.shape.outline();
  const auto is_known = [](int count) { return count >= 3 && count <= most_vertices; };
  if (!is_known(a.count) || !is_known(b.count)) __builtin_unreachable();

  const TurnAboutZ<TwoLanes> about_z = turns_about_z(pose_a, pose_b);
  if (!are_tolerable(about_z, pose_a, pose_b)) {
    return detect_guarded(&shape_a, &pose_a, &shape_b, &pose_b, nullptr, nullptr, contact);
  }
  const Turns& turns = about_z.turn;
  const Placement<Turns> at = placement_of(turns, pose_a, pose_b);
  const Separation<2> found = find_separation_by_all(a, b, at);
  if (found.gap > 0) {
    answer_separated(found, posed, turns, nullptr, *contact);
    return HS_OK;
  }
  return describe_guarded(shape_a, pose_a, shape_b, found.pair.owner, found.pair.edge, *contact,
                          only(at.into_other, 1), TwoLanes{at.to_other.x[0], at.to_other.y[0]},
                          only(turns, 0));
}

/// The same where a call costs little beside the vertices.
template <int most_vertices>
[[gnu::noinline]] hs_status detect_cold_by_call(const ShapeHandle<2>& a, const hs_pose& at_a,
                                                const ShapeHandle<2>& b, const hs_pose& at_b,
                                                hs_contact* contact) {
  return detect_cold<most_vertices>({a, at_a, b, at_b}, contact);
}

/// hs_pair_detect() with a cache and without options, of what are not two polygons; apart, so that polygons
/// do not pay for the registers that it takes.
[[gnu::noinline]] hs_status detect_in_space(const hs_shape* shape_a, const hs_pose* pose_a,
                                            const hs_shape* shape_b, const hs_pose* pose_b,
                                            hs_pair_cache* cache, hs_contact* contact) {
  if (are_polyhedra(*shape_a, *shape_b) &&
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
    const auto polygons = [&] { return posed_as<2>(*shape_a, *pose_a, *shape_b, *pose_b); };
    if (cache) {
      if (shape_a->dimension() == 3 || shape_b->dimension() == 3)
        return detect_in_space(shape_a, pose_a, shape_b, pose_b, cache, contact);
      if (answer_by_proof(polygons(), *cache, *contact)) return HS_OK;
    } else if (m == 3 && n == 3) {
      return detect_cold<3>(polygons(), contact);
    } else if (m <= 4 && n <= 4) {
      return detect_cold_by_call<4>(as<2>(*shape_a), *pose_a, as<2>(*shape_b), *pose_b, contact);
    } else if (m * n <= most_combinations) {
      return detect_cold_by_call<most_combinations>(as<2>(*shape_a), *pose_a, as<2>(*shape_b), *pose_b,
                                                    contact);
    }
  }
  return detect_guarded(shape_a, pose_a, shape_b, pose_b, options, cache, contact);
}
