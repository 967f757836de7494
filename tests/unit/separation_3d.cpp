#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/separation.h"
#include "polyhedra.h"
#include "rotations.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Gap along a direction from a to b, by its definition.
double gap_along(const Vector<3>& direction, const Outline<3>& a, const Outline<3>& b,
                 const Vector<3>& to_b) {
  double nearest_of_b = HUGE_VAL, farthest_of_a = -HUGE_VAL;
  for (int v = 0; v < b.vertex_count(); ++v)
    nearest_of_b = std::min(nearest_of_b, direction.dot(b.vertex(v) + to_b));
  for (int v = 0; v < a.vertex_count(); ++v)
    farthest_of_a = std::max(farthest_of_a, direction.dot(a.vertex(v)));
  return nearest_of_b - farthest_of_a;
}

/// Largest gap along any normal that a facet of the Minkowski difference can have: those of all faces, and
/// both normals of every two edges. Positive just when the blocks are apart, else the least depth.
double largest_gap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  double largest = -HUGE_VAL;
  const auto judge = [&](const Vector<3>& direction) {
    largest = std::max(largest, gap_along(direction, a, b, to_b));
  };
  for (int f = 0; f < a.face_count(); ++f) judge(a.normal(f));
  for (int f = 0; f < b.face_count(); ++f) judge(-b.normal(f));
  for (int i = 0; i < a.topology->edge_count; ++i) {
    for (int j = 0; j < b.topology->edge_count; ++j) {
      const Vector<3> across = cross_product(edge_vector(a, i), edge_vector(b, j));
      const double sine = across.norm() / (edge_vector(a, i).norm() * edge_vector(b, j).norm());
      if (sine < 1e-9) continue;
      judge(across.normalized());
      judge(-across.normalized());
    }
  }
  return largest;
}

/// The features of a pair, from its indices alone, give the normal and the gap that were found.
void check_features(const Separation<3>& found, const Outline<3>& a, const Outline<3>& b,
                    const Vector<3>& to_b) {
  const PotentialPair<3>& pair = found.pair;
  CHECK(std::abs(found.normal.norm() - 1) < 1e-14);
  CHECK(found.gap == Approx(gap_along(found.normal, a, b, to_b)).margin(1e-14));
  switch (pair.kind) {
    case PotentialPair<3>::face_vertex:
      CHECK(found.normal == a.normal(pair.a));
      CHECK(found.gap == Approx(found.normal.dot(b.vertex(pair.b) + to_b) - a.offset[pair.a]).margin(1e-14));
      break;
    case PotentialPair<3>::vertex_face:
      CHECK(found.normal == -b.normal(pair.b));
      CHECK(found.gap == Approx(found.normal.dot(to_b - a.vertex(pair.a)) - b.offset[pair.b]).margin(1e-14));
      break;
    case PotentialPair<3>::edge_edge: {
      CHECK(std::abs(found.normal.dot(edge_vector(a, pair.a))) < 1e-12);
      CHECK(std::abs(found.normal.dot(edge_vector(b, pair.b))) < 1e-12);
      const Vector<3> p = a.vertex(a.topology->edge_start[pair.a]);
      const Vector<3> q = b.vertex(b.topology->edge_start[pair.b]) + to_b;
      CHECK(found.gap == Approx(found.normal.dot(q - p)).margin(1e-12));
      break;
    }
    case PotentialPair<3>::vertex_vertex:
      CHECK(found.gap > 0);
      CHECK(found.gap == Approx(found.normal.dot(b.vertex(pair.b) + to_b - a.vertex(pair.a))).margin(1e-14));
      break;
  }
}

Separation<3> by_descent(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  return find_separation_by_descent(MinkowskiDifference<NoTurn>(a, b, to_b, NoTurn()));
}

Shape<3> random_shape(Random& random, int points) {
  return shape_of(hull_of(random_cloud(random, points, 0.3, 1)));
}

}  // namespace

TEST_CASE("in space, both searches find the verdict and the least depth of their definition") {
  Random random(1);
  int apart = 0, kinds[4] = {};
  for (int round = 0; round < 300; ++round) {
    const Shape<3> shape_a = random_shape(random, random.integer(4, 12));
    const Shape<3> shape_b = random_shape(random, random.integer(4, 12));
    const Outline<3>&a = shape_a.outline(), &b = shape_b.outline();
    const Vector<3> direction = random_direction(random);
    const Vector<3> to_b = random.uniform(0, 2) * direction;
    const double expected = largest_gap(a, b, to_b);
    apart += expected > 0;
    const Separation<3> all = find_separation_by_all(a, b, to_b), descent = by_descent(a, b, to_b);
    for (const Separation<3>& found : {all, descent}) {
      CAPTURE(round, found.pair.kind, expected);
      CHECK((found.gap > 0) == (expected > 0));
      if (expected <= 0) CHECK(found.gap == Approx(expected).margin(1e-14));
      check_features(found, a, b, to_b);
    }
    ++kinds[all.pair.kind];
  }
  CHECK(apart > 50);
  CHECK(apart < 250);
  for (const int kind :
       {PotentialPair<3>::face_vertex, PotentialPair<3>::vertex_face, PotentialPair<3>::edge_edge})
    CHECK(kinds[kind] > 20);
}

TEST_CASE("in space, large blocks are judged right by descent") {
  Random random(2);
  for (int round = 0; round < 10; ++round) {
    const Shape<3> shape_a = shape_of(hull_of(random_cloud(random, 60, 0.99, 1)));
    const Shape<3> shape_b = shape_of(hull_of(random_cloud(random, 60, 0.99, 1)));
    const Vector<3> direction = random_direction(random);
    const Vector<3> to_b = random.uniform(1, 2.1) * direction;
    const double expected = largest_gap(shape_a.outline(), shape_b.outline(), to_b);
    const Separation<3> found = by_descent(shape_a.outline(), shape_b.outline(), to_b);
    CHECK((found.gap > 0) == (expected > 0));
    if (expected <= 0) CHECK(found.gap == Approx(expected).margin(1e-14));
    check_features(found, shape_a.outline(), shape_b.outline(), to_b);
  }
}

TEST_CASE("cubes stacked face on face touch without overlap, and overlap by what they are pushed together") {
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  const Outline<3>& outline = cube.outline();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double depth : {0.0, 0x1p-30, 0.25}) {
      const Vector<3> to_b = (1 - depth) * Vector<3>::Unit(axis);
      for (const Separation<3>& found :
           {find_separation_by_all(outline, outline, to_b), by_descent(outline, outline, to_b)}) {
        CHECK(found.gap == -depth);
        CHECK(found.normal == Vector<3>::Unit(axis));
        CHECK(found.pair.kind != PotentialPair<3>::edge_edge);
      }
    }
  }
}

/// Prisms of a point-symmetric base, so that the centroid is the origin to rounding.
static Cloud prism(const Cloud& half_of_base, double half_height, const Rotation<3>& turn) {
  Cloud corners;
  for (const Vector<3>& p : half_of_base) {
    for (const double side : {1.0, -1.0}) {
      for (const double up : {half_height, -half_height})
        corners.push_back(turn * Vector<3>(side * p.x(), up, side * p.z()));
    }
  }
  return corners;
}

/// An outline with normals that are as inaccurate as those of faces which were cut.
class WithRoundedNormals {
 public:
  WithRoundedNormals(const Outline<3>& outline, Random& random) : outline_(outline) {
    const double* of_outline[] = {outline.nx, outline.ny, outline.nz};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* components = of_outline[axis];
      normals_[axis].assign(components, components + Outline<3>::padded(outline.face_count()));
      for (double& component : normals_[axis]) component += random.uniform(-1e-16, 1e-16);
    }
    outline_.nx = normals_[0].data();
    outline_.ny = normals_[1].data();
    outline_.nz = normals_[2].data();
  }
  WithRoundedNormals(const WithRoundedNormals&) = delete;
  const Outline<3>& outline() const { return outline_; }

 private:
  std::vector<double> normals_[3];
  Outline<3> outline_;
};

/// The edges around the cut are parallel to rounding, and the sign of their common normal is noise.
TEST_CASE("two parts of a cut block touch at their faces in the cut") {
  Random random(4);
  int overlapping = 0;
  for (int round = 0; round < 1000; ++round) {
    Cloud half_of_base;
    for (int i = random.integer(2, 3); i > 0; --i) half_of_base.push_back(random_vector(random, -1, 1));
    const Rotation<3> turn = round % 2 == 0 ? Rotation<3>() : random_turn(random);
    const Shape<3> shape = shape_of(hull_of(prism(half_of_base, 0.5, turn)));
    const WithRoundedNormals rounded_a(shape.outline(), random), rounded_b(shape.outline(), random);
    const Outline<3>&a = rounded_a.outline(), &b = rounded_b.outline();
    const Vector<3> across = turn * Vector<3>(0, 1, 0);
    const Vector<3> to_b = round % 3 == 0 ? across : Vector<3>(across + 1e-16 * random_direction(random));
    for (const Separation<3>& found : {find_separation_by_all(a, b, to_b), by_descent(a, b, to_b)}) {
      if (found.gap > 0) continue;
      ++overlapping;
      CAPTURE(round, found.gap, found.pair.kind);
      const Vector<3> normal = normal_of(a, b, found.pair);
      CHECK(normal.dot(across) > 1 - 1e-12);
      CHECK(gap_along(normal, a, b, to_b) == Approx(found.gap).margin(1e-13));
    }
  }
  CHECK(overlapping > 500);
}

TEST_CASE("blocks with one centroid overlap by the least distance between their faces") {
  const Shape<3> shape = shape_of(completed(box({1, 2, 3})));
  const Outline<3>& outline = shape.outline();
  CHECK(find_separation_by_all(outline, outline, {0, 0, 0}).gap == -1);
  CHECK(by_descent(outline, outline, {0, 0, 0}).gap == -1);
}

/// What a search reads without having set it is a number beyond every array after this.
[[gnu::noinline]] static void fill_stack() {
  volatile unsigned char bytes[1 << 17];
  for (volatile unsigned char& byte : bytes) byte = 0x7f;
}

/// Affine blocks may be squeezed until nothing is left of their thickness, or of their width either.
TEST_CASE("blocks squeezed flat, to a line or to a point touch there without overlap") {
  const Shape<3> shape = shape_of(completed(box({1, 2, 3})));
  const Outline<3>& whole = shape.outline();
  const std::vector<double> none(std::size_t(Outline<3>::padded(whole.vertex_count())), 0.0);
  for (int left = 0; left < 3; ++left) {
    Outline<3> squeezed = whole;
    std::vector<double> offset(whole.offset, whole.offset + Outline<3>::padded(whole.face_count()));
    const double* normals[] = {whole.nx, whole.ny, whole.nz};
    for (int axis = left; axis < 3; ++axis) {
      (axis == 0 ? squeezed.x : axis == 1 ? squeezed.y : squeezed.z) = none.data();
      for (std::size_t f = 0; f < offset.size(); ++f) {
        if (normals[axis][f] != 0) offset[f] = 0;
      }
    }
    squeezed.offset = offset.data();
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
      fill_stack();
      const Vector<3> to_b(left > 0 ? share : 0, left > 1 ? -share : 0, 0);
      for (const Separation<3>& found :
           {find_separation_by_all(squeezed, squeezed, to_b), by_descent(squeezed, squeezed, to_b)}) {
        CAPTURE(left, share);
        CHECK(found.gap == 0);
        check_features(found, squeezed, squeezed, to_b);
      }
    }
  }
}

TEST_CASE("in space, scaling by powers of two scales the gap, bit for bit") {
  Random random(3);
  for (int round = 0; round < 30; ++round) {
    const Cloud cloud_a = random_cloud(random, 10, 0.3, 1), cloud_b = random_cloud(random, 10, 0.3, 1);
    const Vector<3> direction = random_direction(random);
    const Vector<3> to_b = random.uniform(0, 1.5) * direction;
    const auto scaled = [](Cloud cloud, double factor) {
      for (Vector<3>& p : cloud) p *= factor;
      return cloud;
    };
    const auto found_at = [&](int exponent) {
      const double factor = std::ldexp(1.0, exponent);
      const Shape<3> a = shape_of(hull_of(scaled(cloud_a, factor))),
                     b = shape_of(hull_of(scaled(cloud_b, factor)));
      return std::pair(find_separation_by_all(a.outline(), b.outline(), factor * to_b),
                       by_descent(a.outline(), b.outline(), factor * to_b));
    };
    const auto [all, descent] = found_at(0);
    for (const int exponent : {-100, 7, 100}) {
      const auto [all_scaled, descent_scaled] = found_at(exponent);
      CHECK(all_scaled.gap == std::ldexp(all.gap, exponent));
      CHECK(all_scaled.pair == all.pair);
      CHECK(descent_scaled.gap == std::ldexp(descent.gap, exponent));
      CHECK(descent_scaled.pair == descent.pair);
    }
  }
}

/// Found by the oracle: the facets of the Minkowski difference next to the one that separates are turned from
/// it by less than rounding turns the slivers of an expanding polytope.
TEST_CASE("a needle before a face that is all but in one plane with its neighbours is apart from it") {
  const Cloud needle = {{-0.2843076582342397, -0.54057109757349742, -0.022309192107234858},
                        {-0.29388159913092088, -0.55877313362256986, -0.023059858867394652},
                        {0.24510399729113186, 0.4660327319592395, 0.019232382746760986},
                        {0.41491072052709638, 0.78889522163681425, 0.032556635881965022},
                        {-0.12161395541658528, -0.23123191238781826, -0.0095415605962887989}};
  const Cloud plate = {{0.0070092177896297963, -0.11116113143534213, -0.99349738648734476},
                       {-0.093631594461543885, -0.020325787481758683, 0.1839459146566379},
                       {-0.11501850700307352, -0.138280886691037, -0.75925785052137607},
                       {-0.66594850095298952, -0.31381368731051457, -0.16330724231214627},
                       {0.088154299136881956, 0.0082051065329654341, -0.26821344818199133},
                       {0.3054054465490465, 0.035528221010201685, -0.86748818134789574},
                       {-0.25344781593826993, -0.083655431920210452, 0.2489192429361837},
                       {-0.24413138191913419, -0.0088559792430191533, 0.86336915060528252},
                       {-0.23213186635271194, -0.059213624742596054, 0.37932276207861992},
                       {0.35642555073957621, 0.054242037246561049, -0.90131051508050564},
                       {0.11473575068136758, 0.14719972216156804, 0.83788155982641632},
                       {-0.09224170961358269, 0.057274419086986668, 0.85328818115354899},
                       {-0.31169830097527806, -0.030342411403032069, 0.93682131141192804},
                       {-0.082296281725197748, 0.058236143210869437, 0.82334152197086363},
                       {0.3335944969155954, 0.24875694848909341, 0.87785627970642099},
                       {0.80164291899112616, 0.34048115015658836, -0.1275242376555247},
                       {-0.0041047381834373722, -0.046241995655689705, -0.38623439083419703},
                       {0.17749979236367844, -0.034313535415750003, -0.98205532898706305},
                       {0.06794868610348602, 0.13368392612831631, 0.90058812328235194},
                       {0.55279341371764878, 0.33176263678836387, 0.75522380001941947},
                       {0.82841184918560551, 0.36397024182439225, -0.026399608040328912},
                       {-0.72288710529794276, -0.35523476007083277, -0.30412183275207483},
                       {-0.57448017797198869, -0.17595310467214051, 0.68300578133864076}};
  const Shape<3> a = shape_of(hull_of(needle)), b = shape_of(hull_of(plate));
  const double turn_of_a[] = {0.03277288300703577, -0.16993291082879358, -0.92517143333124086,
                              0.33779662950431855};
  const double turn_of_b[] = {0.31112846800454619, -0.22887537072715342, -0.71052375249010535,
                              0.5881931130326431};
  const Vector<3> at_a(-5.782905995335776, -2.5727092460645951, -1.602186820895211);
  const Vector<3> at_b(-5.8925413323018043, -2.491581977559167, -1.6570470056776279);
  const Rotation<3> into_a = Rotation<3>::from_quaternion(turn_of_a).inverse();
  const Rotation<3> b_in_a = into_a * Rotation<3>::from_quaternion(turn_of_b);
  // The poses are those of points near the centroids.
  const Vector<3> a_to_centroid =
      a.centroid() - Vector<3>(-0.0079576989927035244, -0.015129637997566371, -0.00062431858843846029);
  const Vector<3> b_to_centroid =
      b.centroid() - Vector<3>(0.010504497468630077, 0.017476009417129713, 0.11148493942547244);
  const Vector<3> to_b = into_a * (at_b - at_a) + (b_in_a * b_to_centroid - a_to_centroid);
  // By exact arithmetic the gap is 2.8107961791423719e-09; its rounding is that of coordinates up to 1.
  CHECK(find_separation(a.outline(), b.outline(), to_b, b_in_a).gap == Approx(2.8107961791e-9).margin(1e-14));
}
