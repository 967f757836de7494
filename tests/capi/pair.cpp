// halfspace/pair.h: what is refused.

#include <cmath>
#include <limits>

#include "capi/pair_calls.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

PairCall two_squares() { return PairCall(&PairCall::square); }

const std::vector<Spoiled> spoiled_inputs = {
    {"position[0]", "nan", [](PairCall& c) { c.poses[1].position[0] = nan; }},
    {"position[1]", "-inf", [](PairCall& c) { c.poses[1].position[1] = -inf; }},
    {"position[1]", "1e+80", [](PairCall& c) { c.poses[0].position[1] = 1e80; }},
    {"rotation", "nan", [](PairCall& c) { c.poses[1].rotation[2] = nan; }},
    {"rotation", "inf", [](PairCall& c) { c.poses[1].rotation[3] = inf; }},
    {"rotation", "(0, 0, 0, 0)", [](PairCall& c) { c.poses[1].rotation[3] = 0; }},
    {"rotation", "1.00001", [](PairCall& c) { c.poses[1].rotation[3] = 1.00001; }},
    {"rotation", "(1, 0, 0, 0)",
     [](PairCall& c) {
       c.poses[1] = {{0, 0, 0}, {1, 0, 0, 0}};
     }},
    {"parallel_angle", "-0.1", [](PairCall& c) { c.options.parallel_angle = -0.1; }},
    {"parallel_angle", "0.6", [](PairCall& c) { c.options.parallel_angle = 0.6; }},
    {"parallel_angle", "nan", [](PairCall& c) { c.options.parallel_angle = nan; }},
    {"vertex_zone", "-1", [](PairCall& c) { c.options.vertex_zone = -1; }},
    {"vertex_zone", "0.7", [](PairCall& c) { c.options.vertex_zone = 0.7; }},
    {"vertex_zone", "nan", [](PairCall& c) { c.options.vertex_zone = nan; }},
    {"margin", "-1", [](PairCall& c) { c.options.margin = -1; }},
    {"margin", "inf", [](PairCall& c) { c.options.margin = inf; }},
    {"margin", "nan", [](PairCall& c) { c.options.margin = nan; }},
    {"without_region", "2", [](PairCall& c) { c.options.without_region = 2; }},
    {"without_region", "-1", [](PairCall& c) { c.options.without_region = -1; }},
    {"struct_size", "0", [](PairCall& c) { c.options.struct_size = 0; }},
    {"struct_size", "4", [](PairCall& c) { c.options.struct_size = 4; }},
    {"struct_size", "4294967295", [](PairCall& c) { c.options.struct_size = 0xffffffffu; }},
    {"state", "3", [](PairCall& c) { c.caches[0].state = 3; }},
    {"state", "-1", [](PairCall& c) { c.caches[0].state = -1; }},
    {"pair_kind", "2", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_EDGE_EDGE, 0, 0); }},
    {"pair_kind", "-1", [](PairCall& c) { c.caches[0] = cache_of(2, -1, 0, 0); }},
    {"feature_a", "4", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_FACE_VERTEX, 4, 0); }},
    {"feature_a", "-1", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_VERTEX_FACE, -1, 0); }},
    {"feature_b", "4", [](PairCall& c) { c.caches[0] = cache_of(1, HS_PAIR_VERTEX_FACE, 0, 4); }},
    {"feature_b", "-2", [](PairCall& c) { c.caches[0] = cache_of(2, HS_PAIR_FACE_VERTEX, 0, -2); }},
};

}  // namespace

TEST_CASE("both forms of detection refuse the same bad input and write nothing") {
  for (const Spoiled& s : spoiled_inputs) check_both_forms_refuse(s, two_squares());
}

TEST_CASE("a proof of separation in the cache lets no bad pose through") {
  for (const Spoiled& s : spoiled_inputs) {
    if (s.is_pose()) check_proof_lets_no_bad_pose_through(s, two_squares(), pose_at(4, 0));
  }
}

TEST_CASE("a proof of separation is of its two shapes in their order") {
  PairCall call = two_squares();
  const Shape wide = make_shape(call.context.get(), box(-4, -1, 4, 1));
  check_proof_is_of_its_shapes_in_their_order(call, wide.get());
}

TEST_CASE("hs_pair_detect refuses what is missing") {
  PairCall c = two_squares();
  const hs_shape* s = c.square.get();
  const hs_pose* p = c.poses;
  hs_contact* out = c.contacts;
  CHECK(hs_pair_detect(nullptr, p, nullptr, p, nullptr, nullptr, out) == HS_ERROR_ARGUMENT);
  check_refusals(
      c.context.get(), "hs_pair_detect",
      {{"shape_a", "NULL", [&] { return hs_pair_detect(nullptr, p, s, p, nullptr, nullptr, out); }},
       {"shape_b", "NULL", [&] { return hs_pair_detect(s, p, nullptr, p, nullptr, nullptr, out); }},
       {"pose_a", "NULL", [&] { return hs_pair_detect(s, nullptr, s, p, nullptr, nullptr, out); }},
       {"pose_b", "NULL", [&] { return hs_pair_detect(s, p, s, nullptr, nullptr, nullptr, out); }},
       {"contact", "NULL", [&] { return hs_pair_detect(s, p, s, p, nullptr, nullptr, nullptr); }}});
  CHECK(c.is_untouched());
}

TEST_CASE("hs_pairs_detect refuses what is missing or out of range") {
  PairCall c = two_squares();
  hs_context* context = c.context.get();
  const auto call = [&](const hs_shape* const* shapes, const hs_pose* poses, std::int64_t bodies,
                        const std::int32_t* pairs, std::int64_t count, hs_contact* contacts) {
    return [=, &c] {
      return hs_pairs_detect(c.context.get(), shapes, poses, bodies, pairs, count, nullptr, nullptr, contacts,
                             &c.touching);
    };
  };
  const std::int32_t negative[2] = {0, -1}, beyond[2] = {2, 0};
  const hs_shape* one_missing[2] = {c.square.get(), nullptr};
  CHECK(hs_pairs_detect(nullptr, c.shapes, c.poses, 2, c.pairs, 2, nullptr, nullptr, c.contacts,
                        &c.touching) == HS_ERROR_ARGUMENT);
  check_refusals(context, "hs_pairs_detect",
                 {{"shapes", "NULL", call(nullptr, c.poses, 2, c.pairs, 2, c.contacts)},
                  {"shapes[1]", "NULL", call(one_missing, c.poses, 2, c.pairs, 2, c.contacts)},
                  {"poses", "NULL", call(c.shapes, nullptr, 2, c.pairs, 2, c.contacts)},
                  {"body_count", "-2", call(c.shapes, c.poses, -2, c.pairs, 2, c.contacts)},
                  {"pairs", "NULL", call(c.shapes, c.poses, 2, nullptr, 2, c.contacts)},
                  {"pairs[1]", "-1", call(c.shapes, c.poses, 2, negative, 1, c.contacts)},
                  {"pairs[0]", "2", call(c.shapes, c.poses, 2, beyond, 1, c.contacts)},
                  {"pair_count", "-1", call(c.shapes, c.poses, 2, c.pairs, -1, c.contacts)},
                  {"contacts", "NULL", call(c.shapes, c.poses, 2, c.pairs, 2, nullptr)}});
  CHECK(c.is_untouched());

  // Nothing to do is legal without any arrays.
  CHECK(hs_pairs_detect(context, nullptr, nullptr, 0, nullptr, 0, nullptr, nullptr, nullptr, &c.touching) ==
        HS_OK);
  CHECK(c.touching == 0);
  CHECK(c.batch() == HS_OK);
  CHECK(c.touching == 2);
}

TEST_CASE("positions as large as doubles go give a finite answer or a refusal, never NaN") {
  PairCall c = two_squares();
  for (double far : {1e100, 1e160, 1e300, 1.7e308}) {
    c.poses[0] = pose_at(-far, 0);
    c.poses[1] = pose_at(far, -far, 0.6, 0.8);
    hs_contact contact;
    const hs_status status =
        hs_pair_detect(c.shapes[0], &c.poses[0], c.shapes[1], &c.poses[1], nullptr, nullptr, &contact);
    INFO("positions " << far);
    if (status == HS_ERROR_ARGUMENT) continue;
    REQUIRE(status == HS_OK);
    CHECK(contact.type == HS_CONTACT_NONE);
    CHECK(std::isfinite(contact.gap));
    CHECK((std::isfinite(contact.normal[0]) && std::isfinite(contact.normal[1])));
  }
}

}  // namespace halfspace_test
