// halfspace/pair.h: what is refused.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/refusals.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// A pair in contact, and every argument of both calls within reach of a test that spoils one.
struct PairCall {
  Context context = make_context();
  Shape square = make_shape(context.get(), box(-1, -1, 1, 1));
  const hs_shape* shapes[2] = {square.get(), square.get()};
  hs_pose poses[2] = {pose_at(0, 0), pose_at(1.5, 0)};
  std::int32_t pairs[4] = {0, 1, 1, 0};
  hs_pair_options options{};
  hs_pair_cache caches[2] = {};
  hs_contact contacts[2];
  std::int64_t touching = -5;

  PairCall() {
    require_ok(hs_pair_options_init(&options, sizeof options), context.get());
    std::memset(static_cast<void*>(contacts), 0xee, sizeof contacts);
  }
  hs_status single() {
    return hs_pair_detect(shapes[0], &poses[0], shapes[1], &poses[1], &options, &caches[0], &contacts[0]);
  }
  hs_status batch() {
    return hs_pairs_detect(context.get(), shapes, poses, 2, pairs, 2, &options, caches, contacts, &touching);
  }
  bool is_untouched() const {
    PairCall fresh;
    return std::memcmp(contacts, fresh.contacts, sizeof contacts) == 0 && touching == fresh.touching;
  }
};

/// Both calls with one thing spoiled: refused by both, and nothing is written.
struct Spoiled {
  std::string argument;
  std::string value;
  std::function<void(PairCall&)> spoil;
};

const std::vector<Spoiled> spoiled_inputs = {
    {"position[0]", "nan", [](PairCall& c) { c.poses[1].position[0] = nan; }},
    {"position[1]", "-inf", [](PairCall& c) { c.poses[1].position[1] = -inf; }},
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
  for (const Spoiled& s : spoiled_inputs) {
    PairCall call;
    s.spoil(call);
    hs_pair_cache before[2];
    std::memcpy(before, call.caches, sizeof before);
    check_refusals(call.context.get(), "hs_pair_detect",
                   {{s.argument, s.value, [&] { return call.single(); }}});
    check_refusals(call.context.get(), "hs_pairs_detect",
                   {{s.argument, s.value, [&] { return call.batch(); }}});
    INFO(s.argument << " = " << s.value);
    CHECK(call.is_untouched());
    CHECK(std::memcmp(before, call.caches, sizeof before) == 0);
  }
}

TEST_CASE("a proof of separation in the cache lets no bad pose through") {
  for (const Spoiled& s : spoiled_inputs) {
    if (s.argument != "rotation" && s.argument.substr(0, 8) != "position") continue;
    PairCall call;
    call.poses[1] = pose_at(4, 0);
    REQUIRE(call.batch() == HS_OK);
    REQUIRE(call.touching == 0);
    REQUIRE(call.caches[0].shapes != 0);
    const hs_pair_cache before = call.caches[0];
    s.spoil(call);
    INFO(s.argument << " = " << s.value);
    CHECK(call.single() == HS_ERROR_ARGUMENT);
    CHECK(call.batch() == HS_ERROR_ARGUMENT);
    CHECK(std::memcmp(&before, &call.caches[0], sizeof before) == 0);
  }
}

TEST_CASE("a proof of separation is of its two shapes in their order") {
  PairCall call;
  const Shape wide = make_shape(call.context.get(), box(-4, -1, 4, 1));
  call.poses[1] = pose_at(4, 0);
  REQUIRE(call.single() == HS_OK);
  REQUIRE(call.contacts[0].type == HS_CONTACT_NONE);
  call.shapes[1] = wide.get();
  REQUIRE(call.single() == HS_OK);
  CHECK(call.contacts[0].type != HS_CONTACT_NONE);
  call.poses[1] = pose_at(8, 0);
  REQUIRE(call.single() == HS_OK);
  REQUIRE(call.contacts[0].type == HS_CONTACT_NONE);
  std::swap(call.shapes[0], call.shapes[1]);  // the wide one still reaches the place of the other
  call.poses[1] = pose_at(4.5, 0);
  REQUIRE(call.single() == HS_OK);
  CHECK(call.contacts[0].type != HS_CONTACT_NONE);
}

TEST_CASE("hs_pair_detect refuses what is missing") {
  PairCall c;
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
  PairCall c;
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
  PairCall c;
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
