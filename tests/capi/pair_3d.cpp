// halfspace/pair.h in space: what is refused, contacts whose answer is known, and what a cache may change.

#include <algorithm>
#include <cmath>
#include <limits>

#include "capi/pair_calls.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

const Point3 x_axis = {1, 0, 0}, y_axis = {0, 1, 0}, z_axis = {0, 0, 1};

PairCall two_cubes() { return PairCall(&PairCall::solid, 0.3); }

const std::vector<Spoiled> spoiled_inputs = {
    {"position[0]", "nan", [](PairCall& c) { c.poses[1].position[0] = nan; }},
    {"position[2]", "-inf", [](PairCall& c) { c.poses[1].position[2] = -inf; }},
    {"position[2]", "1e+80", [](PairCall& c) { c.poses[0].position[2] = 1e80; }},
    {"rotation", "nan", [](PairCall& c) { c.poses[1].rotation[0] = nan; }},
    {"rotation", "inf", [](PairCall& c) { c.poses[1].rotation[1] = inf; }},
    {"rotation", "(0, 0, 0, 0)",
     [](PairCall& c) {
       c.poses[1] = {{0, 0, 0}, {0, 0, 0, 0}};
     }},
    {"rotation", "1.00001",
     [](PairCall& c) {
       c.poses[0] = {{0, 0, 0}, {0, 1.00001, 0, 0}};
     }},
    {"parallel_angle", "0.6", [](PairCall& c) { c.options.parallel_angle = 0.6; }},
    {"struct_size", "0", [](PairCall& c) { c.options.struct_size = 0; }},
    {"state", "3", [](PairCall& c) { c.caches[0].state = 3; }},
    {"pair_kind", "4", [](PairCall& c) { c.caches[0] = cache_of(1, 4, 0, 0); }},
    {"pair_kind", "-1", [](PairCall& c) { c.caches[0] = cache_of(1, -1, 0, 0); }},
    {"pair_kind", "3", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_VERTEX_VERTEX, 0, 0); }},
    {"feature_a", "6 faces", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_FACE_VERTEX, 6, 0); }},
    {"feature_a", "-1", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_VERTEX_FACE, -1, 0); }},
    {"feature_a", "12 edges", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_EDGE_EDGE, 12, 0); }},
    {"feature_b", "8 vertices", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_FACE_VERTEX, 0, 8); }},
    {"feature_b", "6 faces", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_VERTEX_FACE, 0, 7); }},
    {"feature_b", "-3", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_VERTEX_VERTEX, 0, -3); }},
    {"normal", "nan",
     [](PairCall& c) {
       detect_pair(c.shapes[0], pose_at(0, 0), c.shapes[1], pose_at({0, 0, 9}), &c.caches[0]);
       c.caches[0].normal[1] = nan;  // of a proof
     }},
    {"has dimension 3", " 2;",
     [](PairCall& c) {
       c.shapes[1] = c.square.get();
       c.poses[1] = pose_at(1.5, 0);
     }},
    {"has dimension 2", " 3;", [](PairCall& c) { c.shapes[0] = c.square.get(); }},
};

}  // namespace

TEST_CASE("in space, both forms of detection refuse the same bad input and write nothing") {
  for (const Spoiled& s : spoiled_inputs) check_both_forms_refuse(s, two_cubes());
}

TEST_CASE("shapes of two dimensions are refused by name, also without options") {
  PairCall c = two_cubes();
  hs_pair_cache empty{};
  for (hs_pair_cache* cache : {static_cast<hs_pair_cache*>(nullptr), &empty}) {
    const auto single = [&] {
      return hs_pair_detect(c.square.get(), &c.poses[0], c.solid.get(), &c.poses[0], nullptr, cache,
                            c.contacts);
    };
    check_refusals(c.context.get(), "hs_pair_detect", {{"shape_a has dimension 2", "shape_b 3", single}});
  }
  c.shapes[1] = c.square.get();
  c.poses[1] = pose_at(1.5, 0);
  check_refusals(c.context.get(), "hs_pairs_detect",
                 {{"shapes[0] has dimension 3", "shapes[1] 2", [&] { return c.batch(); }}});
  CHECK(c.is_untouched());
}

TEST_CASE("in space, a proof of separation lets no bad pose through and is of its two shapes") {
  for (const Spoiled& s : spoiled_inputs) {
    if (s.is_pose()) check_proof_lets_no_bad_pose_through(s, two_cubes(), pose_at(0, 4));
  }
  PairCall call = two_cubes();
  const Shape wide = make_polyhedron(call.context.get(), box_3d({-4, -1, -1}, {4, 1, 1}));
  check_proof_is_of_its_shapes_in_their_order(call, wide.get());
}

TEST_CASE("two cubes meet face to face, however they lie") {
  const Context context = make_context();
  const Shape shape = make_polyhedron(context.get(), cube());
  // b stands on a, 1/8 deep, 1/4 and 1/2 aside; all of it turned and moved.
  for (double angle : {0.0, pi / 2, 1.1}) {
    const hs_pose frame = pose_at({3, -2, 5}, {1, 2, 2}, angle);
    const auto at = [&](const Point3& p) { return turned(frame, p) + vector_of(frame.position); };
    const auto is_at = [&](const double* got, const Point3& p) {
      return length(vector_of(got) - at(p)) <= 1e-14;
    };
    const hs_pose above = pose_at(at({0.25, 0.5, 0.875}), {1, 2, 2}, angle);
    const hs_contact c = detect_pair(shape.get(), frame, shape.get(), above);
    INFO("turned by " << angle);
    CHECK(c.type == HS_CONTACT_FACE_FACE);
    CHECK((c.pair_kind == HS_PAIR_FACE_VERTEX || c.pair_kind == HS_PAIR_VERTEX_FACE));
    if (c.pair_kind == HS_PAIR_FACE_VERTEX) {
      CHECK(c.feature_a == 1);                       // face +z
      CHECK((c.feature_b >= 0 && c.feature_b < 4));  // a vertex of face -z
    } else {
      CHECK(c.feature_b == 0);                       // face -z
      CHECK((c.feature_a >= 4 && c.feature_a < 8));  // a vertex of face +z
    }
    CHECK(length(vector_of(c.normal) - turned(frame, z_axis)) <= 1e-15);
    CHECK(c.gap == Approx(-0.125).epsilon(1e-13));
    CHECK(c.area == Approx(0.375).epsilon(1e-13));
    CHECK(c.length == 0);
    CHECK(c.point_count == 4);
    CHECK(c.reserved == 0);
    // On the contact plane, which is the face of whichever block the pair takes it from.
    const double plane = c.pair_kind == HS_PAIR_FACE_VERTEX ? 0.5 : 0.375;
    CHECK(is_at(c.center, {0.125, 0.25, plane}));
    CHECK(c.center_gap == Approx(-0.125).epsilon(1e-13));
    for (double x : {-0.25, 0.5}) {
      for (double y : {0.0, 0.5}) {
        const auto is_corner = [&](const double(&p)[3]) { return is_at(p, {x, y, plane}); };
        CHECK(std::count_if(c.points, c.points + 4, is_corner) == 1);
      }
    }
    double twice_area = 0;
    for (int i = 0; i < 4; ++i) {
      CHECK(c.gaps[i] == Approx(-0.125).epsilon(1e-13));
      const Point3 p = vector_of(c.points[i]) - vector_of(c.center);
      const Point3 q = vector_of(c.points[(i + 1) % 4]) - vector_of(c.center);
      twice_area += dot(vector_of(c.normal), cross(p, q));
    }
    CHECK(twice_area == Approx(0.75));  // above 0: counter-clockwise about the normal
  }
}

TEST_CASE("the other types of contact in space") {
  const Context context = make_context();
  const Shape shape = make_polyhedron(context.get(), cube());
  const hs_pose below = pose_at({0, 0, 0});
  const double half_diagonal = std::sqrt(0.5), half_space_diagonal = std::sqrt(0.75);

  // On an edge: turned about x by 45 degrees, so that an edge along x lies in the face, 0.01 deep.
  const hs_contact edge_face =
      detect_pair(shape.get(), below, shape.get(), pose_at({0.25, 0, 0.49 + half_diagonal}, x_axis, pi / 4));
  CHECK(edge_face.type == HS_CONTACT_EDGE_FACE);
  CHECK(edge_face.pair_kind == HS_PAIR_FACE_VERTEX);
  CHECK(edge_face.feature_a == 1);
  CHECK(edge_face.gap == Approx(-0.01));
  CHECK(edge_face.point_count == 2);
  CHECK(edge_face.length == Approx(0.75));
  CHECK(edge_face.area == 0);
  CHECK(edge_face.center[0] == Approx(0.125));
  CHECK(edge_face.center[2] == Approx(0.5));

  // On a corner: the space diagonal upright.
  const Point3 axis = cross({1, 1, 1}, z_axis);
  const hs_contact vertex_face =
      detect_pair(shape.get(), below, shape.get(),
                  pose_at({0.125, 0.25, 0.49 + half_space_diagonal}, axis, std::acos(1 / std::sqrt(3.0))));
  CHECK(vertex_face.type == HS_CONTACT_VERTEX_FACE);
  CHECK(vertex_face.pair_kind == HS_PAIR_FACE_VERTEX);
  CHECK(vertex_face.feature_a == 1);
  CHECK(vertex_face.feature_b == 0);  // (-, -, -)
  CHECK(vertex_face.gap == Approx(-0.01));
  CHECK(vertex_face.point_count == 1);
  CHECK(vertex_face.points[0][0] == Approx(0.125));
  CHECK(vertex_face.points[0][1] == Approx(0.25));
  CHECK(vertex_face.points[0][2] == Approx(0.5));
  CHECK(vertex_face.normal[2] == Approx(1));

  // Edge across edge: a turned about x, b about y, both by 45 degrees.
  const hs_contact edge_edge = detect_pair(shape.get(), pose_at({0, 0, 0}, x_axis, pi / 4), shape.get(),
                                           pose_at({0, 0, 2 * half_diagonal - 0.01}, y_axis, pi / 4));
  CHECK(edge_edge.type == HS_CONTACT_EDGE_EDGE);
  CHECK(edge_edge.pair_kind == HS_PAIR_EDGE_EDGE);
  CHECK(edge_edge.gap == Approx(-0.01));
  CHECK(edge_edge.normal[2] == Approx(1));
  CHECK(edge_edge.point_count == 1);
  CHECK(edge_edge.center[2] == Approx(half_diagonal - 0.005));
  std::int32_t ends[24];
  REQUIRE(hs_shape_get_edges(shape.get(), ends, 12, nullptr) == HS_OK);
  const auto ends_are = [&](std::int32_t edge, std::int32_t v, std::int32_t w) {
    const std::int32_t* e = ends + 2 * edge;
    return (e[0] == v && e[1] == w) || (e[0] == w && e[1] == v);
  };
  CHECK(ends_are(edge_edge.feature_a, 6, 7));  // along x, at +y and +z, which the turn brings to the top
  CHECK(ends_are(edge_edge.feature_b, 1, 3));  // along y, at +x and -z: to the bottom

  // Apart by 0.25: the proof names a face alone.
  const hs_contact apart = detect_pair(shape.get(), below, shape.get(), pose_at({0.25, 0.5, 1.25}));
  CHECK(apart.type == HS_CONTACT_NONE);
  CHECK(apart.point_count == 0);
  CHECK(apart.gap == 0.25);
  CHECK(apart.normal[2] == 1);
  CHECK(((apart.pair_kind == HS_PAIR_FACE_VERTEX && apart.feature_a == 1 && apart.feature_b == -1) ||
         (apart.pair_kind == HS_PAIR_VERTEX_FACE && apart.feature_a == -1 && apart.feature_b == 0)));
}

}  // namespace halfspace_test
