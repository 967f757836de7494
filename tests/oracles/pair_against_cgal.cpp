// hs_pair_detect against the exact verdict, on random pairs family by family.
//
//   pair_against_cgal [pairs] [seed]      default 100000 pairs, all families together
//
// Fails when a verdict is wrong outside rounding distance of touching, when a gap is off by more than
// rounding, or when the oracle contradicts itself. Verdicts inside rounding distance are counted, and those
// among them that differ.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "oracles/cgal_polygon.h"
#include "oracles/exact_pair.h"
#include "oracles/random_pairs.h"

namespace halfspace_test {
namespace {

struct Tally {
  long pairs = 0;
  long touching = 0;
  long refused = 0;        // polygons that the library calls faulty: straight to rounding
  long wrong_outside = 0;  // verdict differs and the exact gap is beyond rounding
  long inside = 0;         // within rounding distance of touching
  long differing_inside = 0;
  long gap_off = 0;         // reported gap beyond rounding of the exact one
  double worst_gap = 0;     // error of the gap in units of 2^-53 * extent
  long checked = 0;         // pairs judged by CGAL's Boolean operations too
  long contradictions = 0;  // of the oracle with itself

  void add(const Tally& t) {
    pairs += t.pairs;
    touching += t.touching;
    refused += t.refused;
    wrong_outside += t.wrong_outside;
    inside += t.inside;
    differing_inside += t.differing_inside;
    gap_off += t.gap_off;
    worst_gap = std::max(worst_gap, t.worst_gap);
    checked += t.checked;
    contradictions += t.contradictions;
  }
  bool is_clean() const { return wrong_outside == 0 && gap_off == 0 && contradictions == 0; }
};

void print_polygon(const char* name, const PlacedPolygon& p) {
  std::printf("  %s vertices", name);
  for (const Point& v : *p.vertices) std::printf(" (%a, %a)", v.x, v.y);
  std::printf("\n  %s pose (%a, %a) z %a w %a\n", name, p.pose.position[0], p.pose.position[1],
              p.pose.rotation[2], p.pose.rotation[3]);
}

void print_failure(const char* what, const PlacedPolygon& a, const PlacedPolygon& b,
                   const hs_contact& contact, long double exact) {
  const EdgeAndVertex pair = edge_and_vertex(contact);
  std::printf("%s: type %d gap %.17g edge %d of %d vertex %d, exact %.20Lg\n", what, contact.type,
              contact.gap, pair.edge, pair.owner, pair.vertex, exact);
  print_polygon("a", a);
  print_polygon("b", b);
}

/// Exact gap of the edge that a contact names.
long double gap_of_named_edge(const hs_contact& contact, const PlacedPolygon& a, const PlacedPolygon& b) {
  const EdgeAndVertex pair = edge_and_vertex(contact);
  const std::size_t edge = std::size_t(pair.edge);
  return pair.owner == 0 ? gap_of_edge(a, edge, b) : gap_of_edge(b, edge, a);
}

/// How far the contact's gap is from what it stands for. Separated, or a vertex on an edge: the gap of the
/// edge named, which in contact is also the least depth. An edge-edge contact gives the gap at the deeper end
/// of its region, so its edge is looked at. A vertex-vertex contact has its gap along the sum of two normals:
/// the invariants test looks at that.
long double error_of_gap(const hs_contact& contact, const PlacedPolygon& a, const PlacedPolygon& b,
                         const ExactVerdict& exact) {
  const long double named = gap_of_named_edge(contact, a, b);
  const long double of_value = std::abs(contact.gap - named);
  const long double of_depth = std::abs(named - exact.largest_gap);
  switch (contact.type) {
    case HS_CONTACT_NONE:
      return of_value;
    case HS_CONTACT_VERTEX_EDGE:
      return std::max(of_value, of_depth);
    case HS_CONTACT_EDGE_EDGE:
      return of_depth;
    default:
      return 0;
  }
}

void judge(const PlacedPolygon& a, const PlacedPolygon& b, const hs_contact& contact, Tally& tally) {
  const ExactVerdict exact = exact_verdict(a, b);
  const bool touches = contact.type != HS_CONTACT_NONE;
  const long double unit = 0x1p-53L * extent(a, b);
  const bool inside = std::abs(exact.largest_gap) <= rounding_bound * unit;
  ++tally.pairs;
  tally.touching += touches;
  tally.inside += inside;
  if (touches != exact.touches) {
    if (inside)
      ++tally.differing_inside;
    else if (++tally.wrong_outside <= 2)
      print_failure("WRONG VERDICT", a, b, contact, exact.largest_gap);
  }
  if (touches == exact.touches) {
    const double error = double(error_of_gap(contact, a, b, exact) / unit);
    tally.worst_gap = std::max(tally.worst_gap, error);
    if (!(error <= rounding_bound) && ++tally.gap_off <= 2) {
      print_failure("GAP OFF", a, b, contact, exact.largest_gap);
    }
  }
}

/// The filtered verdict against the exact one without filter, and that against CGAL's Boolean set operations.
void check_the_oracle(const PlacedPolygon& a, const PlacedPolygon& b, Tally& tally) {
  ++tally.checked;
  const int sign = sign_of_largest_gap(a, b);
  const bool agrees = exact_verdict(a, b).touches == (sign <= 0) &&
                      interiors_overlap(placed_exactly(a), placed_exactly(b)) == (sign < 0);
  tally.contradictions += !agrees;
}

Tally run(Family family, long pairs, std::uint64_t seed) {
  constexpr int placements_of_a_pair = 4;
  constexpr long check_one_in = 50;
  const Context context = make_context();
  Random random(seed + std::uint64_t(family));
  Tally tally;
  while (tally.pairs < pairs) {
    const PolygonPair polygons = draw_polygons(family, random);
    const Shape a = try_shape(context.get(), polygons.a);
    const Shape b = try_shape(context.get(), polygons.b);
    if (!a || !b) {
      ++tally.refused;
      continue;
    }
    const hs_shape_properties of_a = properties_of(a.get());
    const hs_shape_properties of_b = properties_of(b.get());
    for (int i = 0; i < placements_of_a_pair && tally.pairs < pairs; ++i) {
      const PosePair poses = draw_poses(family, polygons, a.get(), b.get(), random);
      hs_contact contact{};
      require_ok(hs_pair_detect(a.get(), &poses.a, b.get(), &poses.b, nullptr, nullptr, &contact),
                 context.get());
      const PlacedPolygon placed_a{&polygons.a, {of_a.centroid[0], of_a.centroid[1]}, poses.a};
      const PlacedPolygon placed_b{&polygons.b, {of_b.centroid[0], of_b.centroid[1]}, poses.b};
      judge(placed_a, placed_b, contact, tally);
      if (tally.pairs % check_one_in == 0) check_the_oracle(placed_a, placed_b, tally);
      if (is_placed_by_vertices(family)) break;
    }
  }
  return tally;
}

void print_row(const char* name, const Tally& t) {
  std::printf("%-16s %9ld %9ld %9ld %9ld %9ld %11.2f %9ld %9ld\n", name, t.pairs, t.touching, t.wrong_outside,
              t.inside, t.differing_inside, t.worst_gap, t.refused, t.checked);
}

int main(long pairs, std::uint64_t seed) {
  std::printf(
      "rounding distance: %g * 2^-53 * (radius a + radius b + distance of centroids); gap error in 2^-53 * "
      "the same\n",
      rounding_bound);
  std::printf("%-16s %9s %9s %9s %9s %9s %11s %9s %9s\n", "family", "pairs", "touching", "wrong", "inside",
              "differ", "gap error", "refused", "checked");
  Tally total;
  const long families = long(std::size(all_families));
  for (Family family : all_families) {
    const Tally tally = run(family, (pairs + families - 1) / families, seed);
    print_row(name_of(family), tally);
    total.add(tally);
  }
  print_row("all", total);
  if (total.gap_off > 0) std::printf("gaps off by more than rounding: %ld\n", total.gap_off);
  if (total.contradictions > 0)
    std::printf("the oracle contradicts itself: %ld times\n", total.contradictions);
  return total.is_clean() ? 0 : 1;
}

}  // namespace
}  // namespace halfspace_test

int main(int argc, char** argv) {
  const long pairs = argc > 1 ? std::atol(argv[1]) : 100000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return halfspace_test::main(pairs, seed);
}
