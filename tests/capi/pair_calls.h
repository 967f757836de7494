#pragma once

// Both forms of pair detection on two blocks in contact, with every argument within reach of a test that
// spoils one; and what must hold in the plane as in space.

#include <algorithm>
#include <cstring>
#include <utility>

#include "capi/polyhedra.h"
#include "capi/refusals.h"

namespace halfspace_test {

/// Two blocks of one shape, asked about as one pair and as two. A shape of either dimension is at hand.
struct PairCall {
  Context context = make_context();
  Shape square = make_shape(context.get(), box(-1, -1, 1, 1));
  Shape solid = make_polyhedron(context.get(), cube(2));
  const hs_shape* shapes[2];
  hs_pose poses[2];
  std::int32_t pairs[4] = {0, 1, 1, 0};
  hs_pair_options options{};
  hs_pair_cache caches[2] = {};
  hs_contact contacts[2];
  std::int64_t touching = not_written;

  /// Of the square or the solid, b at 1.5 on the x axis and turned about it.
  explicit PairCall(Shape PairCall::*shape, double turn_of_b = 0)
      : shapes{(this->*shape).get(), (this->*shape).get()},
        poses{pose_at(0, 0), pose_at({1.5, 0, 0}, {1, 0, 0}, turn_of_b)} {
    require_ok(hs_pair_options_init(&options, sizeof options), context.get());
    std::memset(static_cast<void*>(contacts), not_written_byte, sizeof contacts);
  }
  hs_status single() {
    return hs_pair_detect(shapes[0], &poses[0], shapes[1], &poses[1], &options, &caches[0], &contacts[0]);
  }
  hs_status batch() {
    return hs_pairs_detect(context.get(), shapes, poses, 2, pairs, 2, &options, caches, contacts, &touching);
  }
  bool is_untouched() const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(contacts);
    return touching == not_written && std::all_of(bytes, bytes + sizeof contacts, [](unsigned char byte) {
             return byte == not_written_byte;
           });
  }

 private:
  static constexpr std::int64_t not_written = -5;
  static constexpr unsigned char not_written_byte = 0xee;
};

/// One thing spoiled, and what the text of the refusal must name.
struct Spoiled {
  std::string argument;
  std::string value;
  std::function<void(PairCall&)> spoil;

  bool is_pose() const { return argument == "rotation" || argument.substr(0, 8) == "position"; }
};

inline void check_both_forms_refuse(const Spoiled& spoiled, PairCall call) {
  spoiled.spoil(call);
  hs_pair_cache before[2];
  std::memcpy(before, call.caches, sizeof before);
  check_refusals(call.context.get(), "hs_pair_detect",
                 {{spoiled.argument, spoiled.value, [&] { return call.single(); }}});
  check_refusals(call.context.get(), "hs_pairs_detect",
                 {{spoiled.argument, spoiled.value, [&] { return call.batch(); }}});
  INFO(spoiled.argument << " = " << spoiled.value);
  CHECK(call.is_untouched());
  CHECK(std::memcmp(before, call.caches, sizeof before) == 0);
}

/// With b so far away that a proof of separation is in the cache before the pose is spoiled.
inline void check_proof_lets_no_bad_pose_through(const Spoiled& spoiled, PairCall call, const hs_pose& away) {
  call.poses[1] = away;
  REQUIRE(call.batch() == HS_OK);
  REQUIRE(call.touching == 0);
  REQUIRE(call.caches[0].shapes != 0);
  const hs_pair_cache before = call.caches[0];
  spoiled.spoil(call);
  INFO(spoiled.argument << " = " << spoiled.value);
  CHECK(call.single() == HS_ERROR_ARGUMENT);
  CHECK(call.batch() == HS_ERROR_ARGUMENT);
  CHECK(std::memcmp(&before, &call.caches[0], sizeof before) == 0);
}

/// A proof found for two blocks 2 wide, put to the test with one that is 8 wide along x.
inline void check_proof_is_of_its_shapes_in_their_order(PairCall& call, const hs_shape* wide) {
  call.poses[1] = pose_at(4, 0);
  REQUIRE(call.single() == HS_OK);
  REQUIRE(call.contacts[0].type == HS_CONTACT_NONE);
  call.shapes[1] = wide;
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

}  // namespace halfspace_test
