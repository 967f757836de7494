#include "world/contacts/contact_list.h"

#include <cmath>

#include "catch.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using Finds = std::vector<Found>;

ContactLaw bonding_law() {
  ContactLaw law = bare_law();
  law.tensile_strength = 1;
  return law;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a pair is apart, has met, is in contact, and is apart again", "", ((int D), D), 2,
                       3) {
  WorldParts<D> parts(normal_spring(1));
  parts.add(cube<D>(), BlockKind::fixed, at<D>(0, 0));
  const std::int32_t moved = parts.add(cube<D>(), BlockKind::rigid, at<D>(1.125, 0.25));
  parts.list_neighbors();
  const auto find_at = [&](double x) {
    parts.blocks.place(moved, at<D>(x, 0.25), {});
    return parts.find_contacts();
  };
  CHECK(find_at(1.125) == Finds{Found::apart});
  CHECK(parts.contacts.count() == 0);
  CHECK(find_at(0.875) == Finds{Found::met});
  REQUIRE(parts.contacts.count() == 1);
  const Contact<D> contact = parts.contacts.contact(0);
  CHECK(contact.gap == Approx(-0.125));
  CHECK(contact.normal.isApprox(Vector<D>::UnitX()));
  CHECK(parts.contacts.contact_between(moved, 0) == 0);
  CHECK_FALSE(parts.contacts.contact_between(moved, moved + 1));
  CHECK(find_at(0.9375) == Finds{Found::in_contact});
  CHECK(parts.contacts.contact(0).gap == Approx(-0.0625));
  CHECK(find_at(1.0625) == Finds{Found::apart});
  CHECK(find_at(0.9375) == Finds{Found::met});
  CHECK(parts.contacts.peak_overlap() == Approx(0.125));
}

TEMPLATE_TEST_CASE_SIG("blocks that touch at first sight are apart, and meet when they overlap", "",
                       ((int D), D), 2, 3) {
  WorldParts<D> parts(normal_spring(1));
  parts.add(cube<D>(), BlockKind::fixed, at<D>(0, 0));
  const std::int32_t moved = parts.add(cube<D>(), BlockKind::rigid, at<D>(1, 0));
  parts.list_neighbors();
  CHECK(parts.find_contacts() == Finds{Found::apart});
  parts.blocks.place(moved, at<D>(1 - 0x1p-20, 0), {});
  CHECK(parts.find_contacts() == Finds{Found::met});
}

TEMPLATE_TEST_CASE_SIG("fresh blocks that touch are bonded, and in contact wherever they go", "",
                       ((int D), D), 2, 3) {
  WorldParts<D> parts(bonding_law());
  const std::int32_t left = parts.add(cube<D>(), BlockKind::rigid, at<D>(-1, 0));
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0));
  const std::int32_t right = parts.add(cube<D>(), BlockKind::rigid, at<D>(1.0625, 0));  // not quite touching
  parts.list_neighbors();
  parts.find_contacts();
  parts.contacts.bond_fresh();
  parts.contacts.end_fresh();
  REQUIRE(parts.neighbors.pairs().size() == 2);
  CHECK(parts.find_contacts() == Finds{Found::met, Found::apart});
  parts.blocks.place(left, at<D>(-1.0625, 0), {});
  parts.blocks.place(right, at<D>(0.9375, 0), {});
  CHECK(parts.find_contacts() == Finds{Found::in_contact, Found::met});
  CHECK(parts.contacts.contact(0).gap == Approx(0.0625));
  parts.blocks.place(right, at<D>(1, 0), {});
  parts.contacts.bond_fresh();
  CHECK_FALSE(parts.neighbors.pairs()[1].bonded);  // no block is fresh any more
  parts.contacts.add_fresh(right, parts.blocks.slot_count());
  parts.contacts.bond_fresh();
  CHECK(parts.neighbors.pairs()[1].bonded);
}

TEMPLATE_TEST_CASE_SIG("what the shear spring of an ended contact held is lost to friction", "", ((int D), D),
                       2, 3) {
  ContactLaw law = bare_law();
  law.tan_friction = 0.5;
  WorldParts<D> parts(law);
  parts.add(cube<D>(), BlockKind::fixed, at<D>(0, 0));
  const std::int32_t moved = parts.add(cube<D>(), BlockKind::rigid, at<D>(0.9375, 0));
  parts.list_neighbors();
  parts.find_contacts();
  REQUIRE(parts.contacts.count() == 1);
  ShearSpring<D>& spring = parts.contacts.shear_of(0);
  spring.force[0] = spring.stiffness = 1.5;
  REQUIRE(energy_of<D>(spring) == 0.75);
  parts.find_contacts();
  CHECK(parts.sums.released == 0);
  parts.blocks.place(moved, at<D>(1.0625, 0), {});
  parts.find_contacts();
  CHECK(parts.sums.released == 0.75);
  CHECK(energy_of<D>(parts.neighbors.shear()[0]) == 0);
}
