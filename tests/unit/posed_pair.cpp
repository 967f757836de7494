#include "narrow_phase/posed_pair.h"

#include <cmath>

#include "catch.h"
#include "kept_pose.h"
#include "narrow_phase/plane/posed_pair.h"
#include "narrow_phase/space/posed_pair.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

template <int D>
Contact<D> look(const Shape<D>& shape, const Kept& at_a, const Kept& at_b, PairCache<D>& witness,
                const PairOptions& options = {}) {
  return search_pair({shape, at_a.given(), shape, at_b.given()}, frames_of<D>(at_a.given(), at_b.given()),
                     options, witness, std::pmr::get_default_resource());
}

}  // namespace

TEST_CASE("polygons that lie turned are described in the frame of their poses") {
  const Shape<2> square = shape_of(rectangle(2, 2)), many = shape_of(regular_polygon(60, 1));
  const double half = std::sqrt(0.5);
  const Kept below{{5, 7, 0}, {0, 0, half, half}}, above{{5, 8.75, 0}, {0, 0, half, half}};
  PairCache<2> witness;
  const Contact<2> contact = look(square, below, above, witness);
  CHECK(contact.type == ContactType::edge_edge);
  CHECK(contact.gap == Approx(-0.25));
  CHECK(contact.normal.isApprox(Vector<2>::UnitY(), 1e-15));
  CHECK(middle_of(contact).isApprox(Vector<2>(5, 7.875), 0.02));
  CHECK(witness.state == PairCache<2>::touching);

  // By the merge, for which b is turned into the frame of a.
  PairCache<2> of_many;
  CHECK(look(many, below, {{5, 8.75, 0}}, of_many).gap < 0);
  CHECK(look(many, below, {{5, 9.25, 0}}, of_many).type == ContactType::none);
}

TEST_CASE("a margin makes a contact of a gap, and a contact may be its pair alone") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  const Kept below{{0, 0, 0}}, above{{0, 2.125, 0}};
  PairCache<2> witness;
  const Contact<2> apart = look(square, below, above, witness);
  CHECK(apart.type == ContactType::none);
  CHECK(apart.gap == 0.125);
  CHECK(witness.state == PairCache<2>::separated);
  PairOptions wide;
  wide.margin = 0.25;
  CHECK(look(square, below, above, witness, wide).point_count == 2);
  wide.with_region = false;
  const Contact<2> bare = look(square, below, above, witness, wide);
  CHECK(bare.type == ContactType::vertex_edge);
  CHECK(bare.point_count == 0);
  CHECK(bare.gap == 0.125);
  CHECK(witness.state == PairCache<2>::unknown);
}

TEST_CASE("polyhedra keep the plane between them, seen by the host, until they meet") {
  const Shape<3> cube = shape_of(completed(box({2, 2, 2})));
  const double half = std::sqrt(0.5);
  const Kept below{{0, 0, 0}, {half, 0, 0, half}};
  PairCache<3> witness;
  for (const double gap : {0.5, 0.25}) {
    const Contact<3> apart = look(cube, below, {{0, 0, 2 + gap}}, witness);
    CHECK(apart.type == ContactType::none);
    CHECK(apart.gap == Approx(gap));
    CHECK(witness.state == PairCache<3>::separated);
    CHECK(witness.proof.isApprox(Vector<3>::UnitZ(), 1e-15));
  }
  const Contact<3> contact = look(cube, below, {{0, 0, 1.75}}, witness);
  CHECK(contact.type == ContactType::face_face);
  CHECK(contact.gap == Approx(-0.25));
  CHECK(contact.normal.isApprox(Vector<3>::UnitZ(), 1e-15));
  CHECK(contact.area == Approx(4));
  CHECK(witness.state == PairCache<3>::touching);
}
