#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "narrow_phase/space/shares.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double angle = 0.01;
const DetectOptions options{angle, 1e-6};

/// A region in the plane z = 0 with a linear gap.
struct Region {
  Points corners;
  Vector<2> slope;
  double at_origin = 0;

  double gap_at(const Vector<2>& p) const { return at_origin + slope.dot(p); }
  Contact<3> shared() const {
    Contact<3> contact;
    contact.normal = z_axis;
    contact.point_count = int(corners.size());
    Vector<2> center = corners.size() > 2 ? shape_of(corners).centroid() : 0.5 * (corners[0] + corners[1]);
    contact.center << center, 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      contact.points[i] << corners[i], 0;
      contact.gaps[i] = gap_at(corners[i]);
    }
    share_stiffness(options, contact);
    return contact;
  }
};

int deepest_of(const Contact<3>& contact) {
  return int(std::min_element(contact.gaps, contact.gaps + contact.point_count) - contact.gaps);
}

/// Ways between corners count as longer by so much.
double softening(const Contact<3>& contact) {
  double reach = 0;
  for (int i = 0; i < contact.point_count; ++i)
    reach = std::max(reach, (contact.points[i] - contact.center).norm());
  return 0.2 * reach;
}

double sum(const Contact<3>& contact, const double* of_point) {
  double total = 0;
  for (int i = 0; i < contact.point_count; ++i) total += of_point[i];
  return total;
}

Points random_corners(Random& random, std::size_t most) {
  while (true) {
    const Points polygon = random_polygon(random, most_region_points, 1);
    if (polygon.size() <= most) return polygon;
  }
}

Vector<2> random_slope(Random& random, double length) {
  const double direction = random.uniform(0, 2 * pi);
  return length * Vector<2>(std::cos(direction), std::sin(direction));
}

/// Half the energy per stiffness, and the force, of springs that push and pull.
struct Spring {
  double energy = 0, force = 0;
  Vector<2> moment{0, 0};

  explicit Spring(const Contact<3>& contact) {
    for (int i = 0; i < contact.point_count; ++i) {
      energy += contact.shares[i] * contact.gaps[i] * contact.gaps[i];
      force += contact.shares[i] * contact.gaps[i];
      moment += contact.shares[i] * contact.gaps[i] * contact.points[i].head<2>();
    }
  }
};

}  // namespace

TEST_CASE("below the zone, shares take the exact mean of any linear function") {
  Random random(81);
  for (int round = 0; round < 300; ++round) {
    const Region region{random_corners(random, most_region_points), random_slope(random, 0.24 * angle)};
    const Contact<3> contact = region.shared();
    CHECK(sum(contact, contact.shares) == Approx(1).epsilon(1e-15));
    Vector<3> mean = Vector<3>::Zero();
    for (int i = 0; i < contact.point_count; ++i) {
      CHECK(contact.shares[i] > 0);
      CHECK(contact.share_rates[i].isZero());
      mean += contact.shares[i] * contact.points[i];
    }
    // The mean of every linear function is its value at the mean place.
    CHECK((mean - contact.center).norm() < 1e-14);
  }
}

TEST_CASE("a corner split into two leaves the sums as they were") {
  Random random(82);
  for (int round = 0; round < 200; ++round) {
    const Region region{random_corners(random, most_region_points - 1),
                        random_slope(random, random.uniform(0, 0.24) * angle), 1};
    // A corner is cut off by a little.
    const double little = 1e-9;
    Region split = region;
    const std::size_t n = region.corners.size(), k = std::size_t(random.integer(0, int(n) - 1));
    const Vector<2> corner = region.corners[k];
    const Vector<2> before = region.corners[(k + n - 1) % n], after = region.corners[(k + 1) % n];
    split.corners[k] = corner + little * (after - corner);
    split.corners.insert(split.corners.begin() + std::ptrdiff_t(k), corner + little * (before - corner));
    const Contact<3> whole = region.shared(), cut = split.shared();
    CHECK(cut.shares[k] + cut.shares[k + 1] == Approx(whole.shares[k]).margin(10 * little));
    CHECK(Spring(cut).energy == Approx(Spring(whole).energy).margin(10 * little));
    CHECK(Spring(cut).force == Approx(Spring(whole).force).margin(10 * little));
    CHECK((Spring(cut).moment - Spring(whole).moment).norm() < 10 * little);
  }
}

TEST_CASE("shares sum up to 1 at every slope, and go over to the lowest points without a jump") {
  Random random(83);
  for (int round = 0; round < 100; ++round) {
    Region region{random_corners(random, most_region_points), {0, 0}};
    const Vector<2> direction = random_slope(random, 1);
    constexpr int steps = 2000;
    const double step = 0.6 * angle / steps;
    Contact<3> before = region.shared();
    for (int i = 1; i <= steps; ++i) {
      region.slope = i * step * direction;
      const Contact<3> contact = region.shared();
      CHECK(sum(contact, contact.shares) == Approx(1).epsilon(1e-15));
      // The rate of a share is at most 1.5 / (angle / 4) of itself, and all shares are brought back to 1 by
      // as much at most, over the sum that is left: at least that of the deepest point.
      const double most = 2 * 6 / angle * step /
                          std::min(before.shares[deepest_of(before)], contact.shares[deepest_of(contact)]);
      for (int k = 0; k < contact.point_count; ++k)
        CHECK(std::abs(contact.shares[k] - before.shares[k]) <= most);
      before = contact;
    }
    // Beyond the zone: all that rise from the deepest by more than half the angle have none.
    const int deepest = deepest_of(before);
    for (int k = 0; k < before.point_count; ++k) {
      const double way = (before.points[k] - before.points[deepest]).norm() + softening(before);
      if (before.gaps[k] - before.gaps[deepest] >= 0.5 * angle * way) CHECK(before.shares[k] == 0);
    }
  }
}

TEST_CASE("shares do not jump where another corner becomes the deepest") {
  Random random(84);
  int changes = 0;
  for (int round = 0; round < 100; ++round) {
    Region region{random_corners(random, most_region_points), {0, 0}};
    constexpr int steps = 4000;
    const double tilt = random.uniform(0.25, 0.6) * angle, step = tilt * 2 * pi / steps;
    Contact<3> before = region.shared();
    for (int i = 0; i <= steps; ++i) {
      const double direction = 2 * pi * i / steps;
      region.slope = tilt * Vector<2>(std::cos(direction), std::sin(direction));
      const Contact<3> contact = region.shared();
      if (i > 0) {
        changes += deepest_of(contact) != deepest_of(before);
        // As above: by the rate of the smooth step, and by that of the sum.
        const double most = 2 * 6 / angle * step /
                            std::min(before.shares[deepest_of(before)], contact.shares[deepest_of(contact)]);
        for (int k = 0; k < before.point_count; ++k)
          CHECK(std::abs(contact.shares[k] - before.shares[k]) <= most);
      }
      before = contact;
    }
  }
  CHECK(changes > 300);
}

TEST_CASE("with the rates of shares the moment is the energy's gradient") {
  Random random(85);
  int kinks = 0;
  for (int round = 0; round < 2000; ++round) {
    Region region{random_corners(random, most_region_points),
                  random_slope(random, random.uniform(0.2, 0.7) * angle), -random.uniform(0.01, 0.1)};
    const Contact<3> contact = region.shared();
    const double mean_square = Spring(contact).energy;
    Vector<2> gradient = 2 * Spring(contact).moment;
    for (int k = 0; k < contact.point_count; ++k)
      gradient += (contact.gaps[k] * contact.gaps[k] - mean_square) * contact.share_rates[k].head<2>();
    const double way = 1e-6 * angle;
    const Vector<2> slope = region.slope;
    Vector<2> ahead, behind;
    for (int k = 0; k < 2; ++k) {
      const auto energy_at = [&](double by) {
        region.slope = slope + by * Vector<2>::Unit(k);
        return Spring(region.shared()).energy;
      };
      ahead[k] = (energy_at(way) - mean_square) / way;
      behind[k] = (mean_square - energy_at(-way)) / way;
    }
    // Where two ways down are as steep the gradient has a kink, which few differences hit upon.
    if ((ahead - behind).norm() > 1e-3 * gradient.norm()) {
      ++kinks;
      continue;
    }
    CHECK((0.5 * (ahead + behind) - gradient).norm() <= 1e-5 * gradient.norm());
  }
  CHECK(kinks < 20);
}

TEST_CASE("the rates of shares are theirs by the slope") {
  // A segment, whose upper end loses its share s: of s / (1 + s), the rate of 1 + s is that of s.
  for (const double slope : {0.28, 0.3, 0.375, 0.45, 0.49}) {
    const auto shares_at = [&](double s) {
      return Region{{{-0.5, 0}, {0.5, 0}}, Vector<2>(s * angle, 0)}.shared();
    };
    const Contact<3> contact = shares_at(slope);
    const double way = 1e-6;
    const auto upper_over_lower = [&](double s) {
      const Contact<3> c = shares_at(s);
      return c.shares[1] / c.shares[0];
    };
    const double rate = (upper_over_lower(slope + way) - upper_over_lower(slope - way)) / (2 * way * angle);
    const double sum_of_both = 1 / contact.shares[0];
    CHECK(contact.share_rates[1].x() == Approx(rate / sum_of_both).epsilon(1e-6));
    CHECK(contact.share_rates[0].isZero());
  }
}
