#pragma once

// Random scenes of two blocks for tests that know no answer, only how answers must be related.

#include <cstring>

#include "capi/handles.h"
#include "oracles/exact_pair.h"
#include "oracles/random_pairs.h"

namespace halfspace_test {

struct Scene {
  hs_context* context;
  Family family;
  PolygonPair polygons;
  Shape a;
  Shape b;
  PosePair poses;

  PlacedPolygon placed_a() const { return placed(polygons.a, a.get(), poses.a); }
  PlacedPolygon placed_b() const { return placed(polygons.b, b.get(), poses.b); }
  double extent() const { return halfspace_test::extent(placed_a(), placed_b()); }

 private:
  static PlacedPolygon placed(const Points& vertices, const hs_shape* shape, const hs_pose& pose) {
    const hs_shape_properties p = properties_of(shape);
    return {&vertices, {p.centroid[0], p.centroid[1]}, pose};
  }
};

/// Calls visit(scene, random) for `count` scenes of each family.
template <class Visit>
void for_each_scene(int count, std::uint64_t seed, Visit visit) {
  const Context context = make_context();
  for (Family family : all_families) {
    Random random(seed + std::uint64_t(family));
    for (int made = 0; made < count;) {
      Scene scene{context.get(), family, draw_polygons(family, random), nullptr, nullptr, {}};
      scene.a = try_shape(context.get(), scene.polygons.a);
      scene.b = try_shape(context.get(), scene.polygons.b);
      if (!scene.a || !scene.b) continue;  // straight to rounding: refused, and counted by the oracle
      scene.poses = draw_poses(family, scene.polygons, scene.a.get(), scene.b.get(), random);
      visit(scene, random);
      ++made;
    }
  }
}

inline hs_contact detect(const hs_shape* a, const hs_pose& pose_a, const hs_shape* b, const hs_pose& pose_b,
                         hs_pair_cache* cache = nullptr) {
  hs_contact contact{};  // what detection does not say stays 0
  const hs_status status = hs_pair_detect(a, &pose_a, b, &pose_b, nullptr, cache, &contact);
  if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
  return contact;
}

inline hs_contact detect(const Scene& s, hs_pair_cache* cache = nullptr) {
  return detect(s.a.get(), s.poses.a, s.b.get(), s.poses.b, cache);
}

inline bool same_bytes(const hs_contact& a, const hs_contact& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool touches(const hs_contact& c) { return c.type != HS_CONTACT_NONE; }

/// Is the gap that of the pair named, edge and vertex? That of a vertex-vertex contact is along the sum of
/// two normals, and that of an edge-edge contact is at the deeper end of its region, where the vertex may lie
/// beyond.
inline bool gap_is_of_the_pair(const hs_contact& c) {
  return c.type == HS_CONTACT_NONE || c.type == HS_CONTACT_VERTEX_EDGE;
}

}  // namespace halfspace_test
