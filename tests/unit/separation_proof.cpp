#include "narrow_phase/separation_proof.h"

#include <cmath>

#include "catch.h"
#include "kept_pose.h"
#include "narrow_phase/plane/posed_pair.h"
#include "narrow_phase/space/posed_pair.h"
#include "polyhedra.h"
#include "rotations.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

template <int D>
Kept random_pose(Random& random, double farthest) {
  Kept kept{};
  for (int i = 0; i < D; ++i) kept.position[i] = random.uniform(-farthest, farthest);
  if constexpr (D == 2) {
    Rotation<2>::from_angle(random.uniform(-3, 3)).write_quaternion(kept.quaternion);
  } else {
    random_turn(random).write_quaternion(kept.quaternion);
  }
  return kept;
}

/// The same pose a little later, its quaternion still one of a turn about z in the plane.
template <int D>
Kept moved(const Kept& before, Random& random, double by) {
  Kept after = before;
  for (int i = 0; i < D; ++i) after.position[i] += random.uniform(-by, by);
  double squared = 0;
  for (int i = D == 2 ? 2 : 0; i < 4; ++i) {
    after.quaternion[i] += random.uniform(-by, by);
    squared += after.quaternion[i] * after.quaternion[i];
  }
  for (double& part : after.quaternion) part /= std::sqrt(squared);
  return after;
}

template <int D>
Contact<D> find_vertex_face(const PosedPair<D>& posed) {
  PairCache<D> witness;
  return search_pair(posed, frames_of<D>(posed.at_a, posed.at_b), {}, witness,
                     std::pmr::get_default_resource());
}

struct Proof {
  std::uint64_t shapes;
  double reach, normal[3], rotation_a[4], rotation_b[4];
};

/// The least that the blocks are apart along the normal of the proof, found anew.
template <int D>
double gap_along(const double normal[3], const PosedPair<D>& posed) {
  const Pose<D> a = pose_of<D>(posed.at_a), b = pose_of<D>(posed.at_b);
  const Vector<D> direction(normal);
  double highest_of_a = -HUGE_VAL, lowest_of_b = HUGE_VAL;
  for (int i = 0; i < posed.a.vertex_count(); ++i)
    highest_of_a =
        std::max(highest_of_a, direction.dot(a.position + a.rotation * posed.a.outline().vertex(i)));
  for (int i = 0; i < posed.b.vertex_count(); ++i)
    lowest_of_b = std::min(lowest_of_b, direction.dot(b.position + b.rotation * posed.b.outline().vertex(i)));
  return lowest_of_b - highest_of_a;
}

/// The rest of a gap is never more than there is, and most of it as long as the blocks hardly move.
template <int D>
void check_proofs(const Shape<D>& a, const Shape<D>& b, Random& random) {
  int proven = 0;
  for (int i = 0; i < 500; ++i) {
    const Kept at_a = random_pose<D>(random, 2), at_b = random_pose<D>(random, 2);
    const PosedPair<D> before{a, at_a.given(), b, at_b.given()};
    const Contact<D> apart = find_vertex_face(before);
    if (apart.type != ContactType::none) continue;
    double normal[3] = {};
    for (int k = 0; k < D; ++k) normal[k] = apart.normal[k];
    Proof proof;
    keep_proof(before, normal, apart.gap, proof);
    CHECK(proven_gap(before, proof, 0) == Approx(apart.gap).margin(1e-12));
    CHECK(proven_gap(before, proof, 2 * apart.gap) == 0);
    CHECK(proven_gap<D>({b, at_b.given(), a, at_a.given()}, proof, 0) == 0);
    const Kept a_later = moved<D>(at_a, random, 0.1), b_later = moved<D>(at_b, random, 0.1);
    const PosedPair<D> after{a, a_later.given(), b, b_later.given()};
    const double left = proven_gap(after, proof, 0);
    proven += left > 0;
    if (left > 0) CHECK(left <= gap_along(normal, after) + 1e-14);
  }
  CHECK(proven > 50);
}

}  // namespace

TEST_CASE("a proof of separation claims no more gap than there is") {
  Random random(3);
  check_proofs(shape_of(regular_polygon(5, 0.7)), shape_of(rectangle(0.4, 1)), random);
  check_proofs(shape_of(completed(box({0.5, 0.7, 0.9}))),
               shape_of(hull_of(random_cloud(random, 20, 0.5, 0.6))), random);
}

TEST_CASE("shapes are told apart by their fingerprints") {
  const Shape<2> square = shape_of(rectangle(1, 1)), wider = shape_of(rectangle(1 + 0x1p-50, 1));
  CHECK(square.fingerprint() % 2 == 1);
  CHECK(square.fingerprint() == shape_of(rectangle(1, 1)).fingerprint());
  CHECK(square.fingerprint() != wider.fingerprint());
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  CHECK(cube.fingerprint() == shape_of(completed(box({1, 1, 1}))).fingerprint());
  CHECK(cube.fingerprint() != shape_of(completed(box({1, 1, 2}))).fingerprint());
}
