#include "detect/separation_3d.h"

#include "detect/edge_pairs.h"
#include "detect/face_pairs.h"

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
  constexpr int most_combinations = 400;
  const int edges_of_a = a.topology->edge_count, edges_of_b = b.topology->edge_count;
  return edges_of_a <= most_edges_in_set && edges_of_b <= most_edges_in_set &&
         edges_of_a * edges_of_b <= most_combinations;
}

Separation<3> find_separation_by_all(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  const FaceGap of_a = largest_face_gap(a, b, to_b);
  if (of_a.gap > 0) return at_face_of_a(of_a, a, b);
  const FaceGap of_b = largest_face_gap(b, a, -to_b);
  if (of_b.gap > 0) return at_face_of_b(of_b, a, b);
  Separation<3> best = of_a.gap >= of_b.gap ? at_face_of_a(of_a, a, b) : at_face_of_b(of_b, a, b);
  judge_edge_pairs(a, b, to_b, best);
  return best;
}

}  // namespace halfspace
