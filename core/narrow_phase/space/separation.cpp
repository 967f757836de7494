#include "narrow_phase/space/separation.h"

#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/sat_edges.h"
#include "narrow_phase/space/sat_faces.h"

// SAT: the largest gap among all potential pairs of two polyhedra. Faces, each with the other's deepest
// vertex behind it, are tested first, as one open face proves separation; then pairs of edges. Blocks of many
// features are searched by descent instead (gjk_epa.h).

namespace halfspace {
namespace {

Separation<3> at_face_of_a(const FaceGap& found, const Outline<3>& a, const Outline<3>& b) {
  const Vector<3> normal = a.normal(found.face);
  const int vertex = deepest_among_all(b, normal).vertex;
  return {found.gap, {PotentialPair<3>::face_vertex, found.face, vertex}, normal};
}

Separation<3> at_face_of_b(const FaceGap& found, const Outline<3>& a, const Outline<3>& b) {
  const Vector<3> normal = b.normal(found.face);
  const int vertex = deepest_among_all(a, normal).vertex;
  return {found.gap, {PotentialPair<3>::vertex_face, vertex, found.face}, -normal};
}

}  // namespace

bool by_all_combinations(const Outline<3>& a, const Outline<3>& b) {
  constexpr int max_combinations = 400;
  const int edges_of_a = a.topology->edge_count, edges_of_b = b.topology->edge_count;
  return edges_of_a <= max_edges_in_set && edges_of_b <= max_edges_in_set &&
         edges_of_a * edges_of_b <= max_combinations;
}

Separation<3> find_separation_by_all(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                     double margin) {
  const FaceGap of_a = largest_face_gap(a, b, to_b);
  if (of_a.gap > margin) return at_face_of_a(of_a, a, b);
  const FaceGap of_b = largest_face_gap(b, a, -to_b);
  if (of_b.gap > margin) return at_face_of_b(of_b, a, b);
  Separation<3> best = of_a.gap >= of_b.gap ? at_face_of_a(of_a, a, b) : at_face_of_b(of_b, a, b);
  judge_edge_pairs(a, b, to_b, best);
  return best;
}

Separation<3> find_largest_separation(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  if (by_all_combinations(a, b)) return find_separation_by_all(a, b, to_b, HUGE_VAL);
  const Separation<3> found = find_separation(a, b, to_b);
  if (found.gap <= 0) return found;
  PotentialPair<3> pair = descend(a, b, to_b, initial_pair(a, b, to_b, witness_of(found)));
  const double gap = refresh(SeenOutline(a), SeenOutline(b), to_b, pair);
  return gap >= found.gap ? Separation<3>{gap, pair, normal_of(a, b, pair)} : found;
}

}  // namespace halfspace
