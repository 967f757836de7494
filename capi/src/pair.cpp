#include "pair.h"

#include "check.h"
#include "contact.h"
#include "detect/pair.h"
#include "detect/turned_outline.h"
#include "guard.h"
#include "posed_pair.h"
#include "separation_proof.h"
#include "shape.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_pair_options default_definition() {
  const DetectOptions defaults;
  return {0, 0, defaults.parallel_angle, defaults.vertex_zone};
}

DetectOptions read_detect_options(double parallel_angle, double vertex_zone) {
  require(parallel_angle >= 0 && parallel_angle <= 0.5, parallel_angle, "parallel_angle",
          "from 0 to 0.5 rad");
  require(vertex_zone >= 0 && vertex_zone <= 0.5, vertex_zone, "vertex_zone", "from 0 to 0.5");
  return {parallel_angle, vertex_zone};
}

namespace {

DetectOptions read_options(const hs_pair_options* options) {
  if (!options) return {};
  const hs_pair_options known = read_definition(options, "options");
  return read_detect_options(known.parallel_angle, known.vertex_zone);
}

PairMemory<2> read_cache(const hs_pair_cache& cache, const Outline<2>& a, const Outline<2>& b) {
  if (cache.state < PairMemory<2>::unknown || cache.state > PairMemory<2>::touching) {
    refuse(HS_ERROR_ARGUMENT, "cache->state is %d; it must be 0, 1 or 2", cache.state);
  }
  PairMemory<2> memory;
  if (cache.state == PairMemory<2>::unknown) return memory;
  memory.state = PairMemory<2>::State(cache.state);
  if (cache.edge < 0 || cache.edge >= a.count + b.count) {
    refuse(HS_ERROR_ARGUMENT, "cache->edge is %d; the shapes have %d edges", cache.edge, a.count + b.count);
  }
  memory.pair = pair_in(cache, a.count);
  const int vertices = memory.pair.owner == 0 ? b.count : a.count;
  if (cache.vertex < 0 || cache.vertex >= vertices) {
    refuse(HS_ERROR_ARGUMENT, "cache->vertex is %d; the shape has %d vertices", cache.vertex, vertices);
  }
  return memory;
}

void write_cache(const PairMemory<2>& memory, int edges_of_a, hs_pair_cache& cache) {
  const PotentialPair<2>& pair = memory.pair;
  cache.state = memory.state;
  cache.edge = pair.owner == 0 ? pair.edge : pair.edge + edges_of_a;
  cache.vertex = pair.vertex;
  cache.reserved = 0;
  cache.shapes = 0;
}

/// The cache may be NULL.
[[gnu::always_inline]] inline void answer_separated(const Separation<2>& separation, const PosedPair& posed,
                                                    const Turns& turns, hs_pair_cache* cache,
                                                    hs_contact& out) {
  write_separation(separation.pair, normal_from_a_to_b(separation.pair, posed, turns), separation.gap, out);
  if (!cache) return;
  write_cache({PairMemory<2>::separated, separation.pair}, posed.a.shape.vertex_count(), *cache);
  keep_proof(posed, out, *cache);
}

void answer_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                    const Rotation<2>& rotation_of_a, const hs_pose& at_a,
                    const PotentialPair<2>& least_depth, const DetectOptions& options, PairMemory<2>& memory,
                    hs_pair_cache* cache, hs_contact& out) {
  Contact<2> contact;
  describe_overlap(a, b, to_b, least_depth, options, memory, contact);
  write_contact(contact, rotation_of_a, {at_a.position[0], at_a.position[1]}, out);
  if (cache) write_cache(memory, a.count, *cache);
}

/// By looking at the shapes, each in its own frame as long as that will do.
void judge(const PosedPair& posed, const DetectOptions& options, hs_pair_cache* cache, hs_contact& out) {
  const Turns turns = read_turns(posed.at_a, posed.at_b);
  const Placement<Turns> at = placement_of(turns, posed.at_a, posed.at_b);
  const Outline<2>& a = posed.a.shape.outline();
  const Outline<2>& b = posed.b.shape.outline();
  PairMemory<2> memory;
  if (cache) memory = read_cache(*cache, a, b);
  if (memory.state == PairMemory<2>::separated) {
    const double gap = refresh(a, b, at, memory.pair);
    if (gap > 0) return answer_separated({gap, memory.pair}, posed, turns, cache, out);
  }
  Separation<2> found;
  const bool by_all = by_all_combinations(a, b);
  if (by_all) {
    found = find_separation_by_all(a, b, at);
    if (found.gap > 0) return answer_separated(found, posed, turns, cache, out);
  }
  const Vector<2> to_b = only(at.to_other, 0);
  const Rotation<2> b_in_a = only(at.into_other, 1);
  const TurnedOutline turned(b, b_in_a, &posed.a.context->memory);
  if (!by_all) {
    found = find_separation_by_merge(a, turned.outline(), to_b);
    if (found.gap > 0) return answer_separated(found, posed, turns, cache, out);
  }
  answer_overlap(a, turned.outline(), to_b, only(turns, 0), posed.at_a, found.pair, options, memory, cache,
                 out);
}

/// By the proof in the cache, or else by looking at the shapes.
void detect(const PosedPair& posed, const DetectOptions& options, hs_pair_cache* cache, hs_contact& out) {
  if (!cache || !answer_by_proof(posed, *cache, out)) judge(posed, options, cache, out);
}

/// hs_pair_detect() when it takes more than the proof in the cache; apart from it, so that the proof is all
/// that is paid for there.
[[gnu::noinline]] hs_status detect_guarded(const hs_shape* shape_a, const hs_pose* pose_a,
                                           const hs_shape* shape_b, const hs_pose* pose_b,
                                           const hs_pair_options* options, hs_pair_cache* cache,
                                           hs_contact* contact) {
  hs_context* context = shape_a ? shape_a->context : shape_b ? shape_b->context : nullptr;
  return guarded(context, "hs_pair_detect", [&] {
    require_pointer(shape_a, "shape_a");
    require_pointer(shape_b, "shape_b");
    require_pointer(pose_a, "pose_a");
    require_pointer(pose_b, "pose_b");
    require_pointer(contact, "contact");
    detect({*shape_a, *pose_a, *shape_b, *pose_b}, read_options(options), cache, *contact);
    return HS_OK;
  });
}

/// The contact of blocks that detect_cold() has found to overlap. What it knows of the poses is handed over
/// in registers.
[[gnu::noinline]] hs_status describe_guarded(const hs_shape& a, const hs_pose& at_a, const hs_shape& b,
                                             int owner, int edge, hs_contact& out, Rotation<2> b_in_a,
                                             TwoLanes to_b, Rotation<2> rotation_of_a) {
  return guarded(a.context, "hs_pair_detect", [&] {
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
[[gnu::always_inline]] inline hs_status detect_cold(const hs_shape* shape_a, const hs_pose* pose_a,
                                                    const hs_shape* shape_b, const hs_pose* pose_b,
                                                    hs_contact* contact) {
  const Outline<2>& a = shape_a->shape.outline();
  const Outline<2>& b = shape_b->shape.outline();
  const auto is_known = [](int count) { return count >= 3 && count <= most_vertices; };
  if (!is_known(a.count) || !is_known(b.count)) __builtin_unreachable();

  const TurnAboutZ<TwoLanes> about_z = turns_about_z(*pose_a, *pose_b);
  if (!are_tolerable(about_z, *pose_a, *pose_b)) {
    return detect_guarded(shape_a, pose_a, shape_b, pose_b, nullptr, nullptr, contact);
  }
  const Turns& turns = about_z.turn;
  const Placement<Turns> at = placement_of(turns, *pose_a, *pose_b);
  const Separation<2> found = find_separation_by_all(a, b, at);
  if (found.gap > 0) {
    answer_separated(found, {*shape_a, *pose_a, *shape_b, *pose_b}, turns, nullptr, *contact);
    return HS_OK;
  }
  return describe_guarded(*shape_a, *pose_a, *shape_b, found.pair.owner, found.pair.edge, *contact,
                          only(at.into_other, 1), TwoLanes{at.to_other.x[0], at.to_other.y[0]},
                          only(turns, 0));
}

/// The same where a call costs little beside the vertices.
template <int most_vertices>
[[gnu::noinline]] hs_status detect_cold_by_call(const hs_shape* shape_a, const hs_pose* pose_a,
                                                const hs_shape* shape_b, const hs_pose* pose_b,
                                                hs_contact* contact) {
  return detect_cold<most_vertices>(shape_a, pose_a, shape_b, pose_b, contact);
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
    const Outline<2>& a = shape_a->shape.outline();
    const Outline<2>& b = shape_b->shape.outline();
    if (cache) {
      if (answer_by_proof({*shape_a, *pose_a, *shape_b, *pose_b}, *cache, *contact)) return HS_OK;
    } else if (a.count == 3 && b.count == 3) {
      return detect_cold<3>(shape_a, pose_a, shape_b, pose_b, contact);
    } else if (a.count <= 4 && b.count <= 4) {
      return detect_cold_by_call<4>(shape_a, pose_a, shape_b, pose_b, contact);
    } else if (by_all_combinations(a, b)) {
      return detect_cold_by_call<most_combinations>(shape_a, pose_a, shape_b, pose_b, contact);
    }
  }
  return detect_guarded(shape_a, pose_a, shape_b, pose_b, options, cache, contact);
}

hs_status hs_pairs_detect(hs_context* context, const hs_shape* const* shapes, const hs_pose* poses,
                          int64_t body_count, const int32_t* pairs, int64_t pair_count,
                          const hs_pair_options* options, hs_pair_cache* caches, hs_contact* contacts,
                          int64_t* touching) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_count(body_count, "body_count");
    require_count(pair_count, "pair_count");
    if (body_count > 0) {
      require_pointer(shapes, "shapes");
      require_pointer(poses, "poses");
    }
    if (pair_count > 0) {
      require_pointer(pairs, "pairs");
      require_pointer(contacts, "contacts");
    }
    const DetectOptions known = read_options(options);

    // All input is judged before anything is written.
    for (std::int64_t i = 0; i < body_count; ++i) {
      char name[48];
      std::snprintf(name, sizeof name, "poses[%lld]", static_cast<long long>(i));
      if (!shapes[i]) refuse(HS_ERROR_ARGUMENT, "shapes[%lld] is NULL", static_cast<long long>(i));
      read_pose(&poses[i], name);
    }
    for (std::int64_t i = 0; i < 2 * pair_count; ++i) {
      if (pairs[i] < 0 || pairs[i] >= body_count) {
        refuse(HS_ERROR_ARGUMENT, "pairs[%lld] is %d; there are %lld bodies", static_cast<long long>(i),
               pairs[i], static_cast<long long>(body_count));
      }
    }
    const auto posed = [&](std::int64_t i) {
      const std::int32_t a = pairs[2 * i], b = pairs[2 * i + 1];
      return PosedPair{*shapes[a], poses[a], *shapes[b], poses[b]};
    };
    for (std::int64_t i = 0; i < pair_count; ++i) {
      const PosedPair pair = posed(i);
      read_turns(pair.at_a, pair.at_b);
      if (caches) read_cache(caches[i], pair.a.shape.outline(), pair.b.shape.outline());
    }

    std::int64_t count = 0;
    for (std::int64_t i = 0; i < pair_count; ++i) {
      detect(posed(i), known, caches ? &caches[i] : nullptr, contacts[i]);
      count += contacts[i].type != HS_CONTACT_NONE;
    }
    if (touching) *touching = count;
    return HS_OK;
  });
}
