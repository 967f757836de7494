// Blocks whose faces are flush, or that are in one place: there rounding decides, vertex by vertex, on which
// side of a plane a face is.

#include <cmath>
#include <new>

#include "catch.h"
#include "contacts_3d.h"
#include "force/potential/potential_force.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

/// Of height 1 along z and unit circumradius.
Cloud prism(int sides) {
  Cloud corners;
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = 2 * pi * (i / 2) / sides;
    corners.push_back({std::cos(angle), std::sin(angle), i % 2 ? 0.5 : -0.5});
  }
  return corners;
}

/// Memory that runs out after so many calls.
class Scarce : public std::pmr::memory_resource {
 public:
  int left = 0;

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    if (--left < 0) throw std::bad_alloc();
    return memory->allocate(bytes, alignment);
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override {
    memory->deallocate(at, bytes, alignment);
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

}  // namespace

TEST_CASE("prisms that are flush, or in one place, share what they share however they are turned") {
  Random random(101);
  PotentialRoom<3> room(memory);
  for (const int sides : {4, 6, 9}) {
    for (int round = 0; round < 500; ++round) {
      const Eigen::Matrix3d turn = random_rotation(random);
      Cloud corners = prism(sides);
      for (Vector<3>& corner : corners) corner = turn * corner;
      const Shape<3> block = shape_of(hull_of(corners));
      const Vector<3> up = turn.col(2);
      for (const double overlap : {1.0, 0.1, 1e-3, 1e-6}) {
        const PotentialForce<3> found =
            potential_force(block.outline(), block.outline(), Vector<3>((1 - overlap) * up), room);
        // What is nearest to one of the faces that meet is a frustum, whose sides lean by as much as they
        // rise. Blocks in one place push no way.
        const double inradius = std::cos(pi / sides), area = block.volume();
        const double frustum = area * inradius / 3 * (1 - std::pow(1 - overlap / inradius, 3));
        const Vector<3> pushed = overlap == 1 ? Vector<3>(Vector<3>::Zero()) : Vector<3>(2 * frustum * up);
        // Corners are off by roundings of coordinates of about 1.
        INFO(sides << " sides, overlap " << overlap);
        CHECK(found.content == Approx(area * overlap).margin(1e-13));
        CHECK((found.force - pushed).norm() <= 1e-13);
      }
    }
  }
}

TEST_CASE("a cube in the place of another stores the integral of its depth for each") {
  Random random(102);
  PotentialRoom<3> room(memory);
  for (int round = 0; round < 500; ++round) {
    const Eigen::Matrix3d turn = random_rotation(random);
    Cloud corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back(turn * Vector<3>(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5));
    const Shape<3> cube = shape_of(hull_of(corners));
    const PotentialForce<3> found =
        potential_force(cube.outline(), cube.outline(), Vector<3>(Vector<3>::Zero()), room);
    CHECK(found.content == Approx(1).margin(1e-13));
    // Six pyramids on the faces, in each of which the mean depth is a quarter of the height.
    CHECK(found.energy == Approx(2 * 0.125).margin(1e-13));
  }
}

TEST_CASE("a room that memory ran out for gives the same results as a new one") {
  Random random(103);
  int ran_out = 0;
  for (int round = 0; round < 200; ++round) {
    Scarce scarce;
    PotentialRoom<3> room(&scarce);
    for (int pair = 0; pair < 12; ++pair) {
      const Shape<3> a = random_block(random, random.integer(4, 60)),
                     b = random_block(random, random.integer(4, 60));
      const Vector<3> to_b = random.uniform(0, 1.2) * random_direction(random);
      scarce.left = random.integer(0, 12);
      try {
        potential_force(a.outline(), b.outline(), to_b, room);
      } catch (const std::bad_alloc&) {
        ++ran_out;
      }
      scarce.left = 1000;
      PotentialRoom<3> fresh(memory);
      const PotentialForce<3> found = potential_force(a.outline(), b.outline(), to_b, room),
                              expected = potential_force(a.outline(), b.outline(), to_b, fresh);
      CHECK(found.force == expected.force);
      CHECK(found.energy == expected.energy);
    }
  }
  CHECK(ran_out > 100);
}
