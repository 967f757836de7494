// Saving and restoring a world in the middle of dense contact.

#include <cstring>
#include <random>

#include "capi/refusals.h"
#include "capi/snapshot_worlds.h"

namespace halfspace_test {
namespace {

constexpr int blocks = 60;
constexpr double time_to_pile_up = 2;  // s: the highest block falls 7 m in 1.2 s

/// Not as a comparison of vectors, whose failure would print every byte.
bool same(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) { return a == b; }

}  // namespace

TEST_CASE("a restored world goes on bit for bit in the middle of dense contact") {
  const Context context = make_context(), elsewhere = make_context();
  const Pile pile(context.get(), blocks);
  run(context.get(), pile.world.get(), time_to_pile_up);
  const std::int64_t contacts = report_of(pile.world.get()).contact_count;
  CHECK(contacts > blocks);
  const std::vector<unsigned char> bytes = saved(pile.world.get());
  CHECK(same(saved(pile.world.get()), bytes));  // saving changes nothing
  const World copy = restored(elsewhere.get(), bytes);
  CHECK(same(saved(copy.get()), bytes));
  for (int steps : {1, 10, 1000}) {
    REQUIRE(hs_world_step(pile.world.get(), steps) == HS_OK);
    REQUIRE(hs_world_step(copy.get(), steps) == HS_OK);
    const std::vector<hs_pose> one = poses_of(pile.world.get()), other = poses_of(copy.get());
    REQUIRE(one.size() == other.size());
    CHECK(std::memcmp(one.data(), other.data(), one.size() * sizeof(hs_pose)) == 0);
    CHECK(same(saved(pile.world.get()), saved(copy.get())));
    const hs_world_report r = report_of(pile.world.get()), q = report_of(copy.get());
    CHECK(std::memcmp(&r, &q, sizeof r) == 0);
  }
  const std::vector<hs_contact> here = contacts_of(pile.world.get()), there = contacts_of(copy.get());
  REQUIRE(here.size() == there.size());
  CHECK(std::memcmp(here.data(), there.data(), here.size() * sizeof(hs_contact)) == 0);
  std::printf("snapshot of %d blocks with %lld contacts: %zu bytes\n", blocks, (long long)contacts,
              bytes.size());
}

TEST_CASE("saving and restoring at every step changes no bit") {
  const Context context = make_context();
  const Pile pile(context.get(), 20);
  run(context.get(), pile.world.get(), time_to_pile_up);
  World carried = restored(context.get(), saved(pile.world.get()));
  for (int i = 0; i < 50; ++i) {
    REQUIRE(hs_world_step(carried.get(), 1) == HS_OK);
    carried = restored(context.get(), saved(carried.get()));
  }
  REQUIRE(hs_world_step(pile.world.get(), 50) == HS_OK);
  CHECK(same(saved(carried.get()), saved(pile.world.get())));
}

TEST_CASE("a world with bodies, bonds and failed points goes on bit for bit") {
  for (const int dimension : {2, 3}) {
    for (const std::int32_t law : all_laws) {
      INFO(dimension << "D, law " << law);
      const Context context = make_context(), elsewhere = make_context();
      const std::vector<unsigned char> bytes = snapshot_of(context.get(), {dimension, law, HS_BLOCK_MESH});
      const World one = restored(context.get(), bytes);
      World other = restored(elsewhere.get(), bytes);
      CHECK(same(saved(one.get()), bytes));
      const std::vector<hs_bond_event> failed = bond_events_of(one.get());
      REQUIRE(!failed.empty());
      const std::vector<hs_bond> bonds = bonds_of(one.get());
      REQUIRE(bonds.size() == 7);  // of a row, and of a ring
      CHECK(bonds[0].damage == 0);
      CHECK(bonds[1].damage > 0);
      CHECK(bonds[1].damage < 1);
      CHECK(bonds[2].damage == 1);
      hs_block of_body = 0;
      for (int i = 0; i < 30; ++i) {
        REQUIRE(hs_world_step(one.get(), 1) == HS_OK);
        REQUIRE(hs_world_step(other.get(), 1) == HS_OK);
        other = restored(elsewhere.get(), saved(other.get()));
      }
      CHECK(same(saved(one.get()), saved(other.get())));
      // Edits, relaxation and strengths live on as well, and so do ids.
      const hs_relaxation_def relaxation = relaxation_def(25, 1e-12);
      for (hs_world* w : {one.get(), other.get()}) {
        REQUIRE(hs_world_set_strength_factor(w, 1.7) == HS_OK);
        const World carried = restored(context.get(), saved(w));
        REQUIRE(hs_world_set_strength_factor(w, 1) == HS_OK);
        REQUIRE(hs_world_set_strength_factor(carried.get(), 1) == HS_OK);
        CHECK(same(saved(carried.get()), saved(w)));
        CHECK(hs_world_relax(w, &relaxation, nullptr, 0) == HS_NOTE_NOT_AT_REST);
        hs_block blocks[64];
        std::int64_t count = 0;
        REQUIRE(hs_world_get_blocks(w, blocks, 64, &count) == HS_OK);
        for (std::int64_t k = 0; k < count; ++k)
          if (state_of(w, blocks[k]).kind == HS_BLOCK_MESH) of_body = blocks[k];
        hs_body body = 0;
        REQUIRE(hs_world_get_body_of_block(w, of_body, &body, nullptr) == HS_OK);
        CHECK(body != 0);
        add_body(w == one.get() ? context.get() : elsewhere.get(), w, bar(dimension, 0.5),
                 body_def(pose_at(-9, 0)));
        REQUIRE(hs_world_remove_body(w, body) == HS_OK);
        REQUIRE(hs_world_step(w, 3) == HS_OK);
      }
      CHECK(same(saved(one.get()), saved(other.get())));
    }
  }
}

TEST_CASE("ids, edits and laws live on in a restored world") {
  TwoBoxes s;
  REQUIRE(hs_world_remove_block(s.world.get(), s.box_away) == HS_OK);
  const World copy = restored(s.context.get(), saved(s.world.get()));
  hs_block_state state;
  CHECK(hs_world_get_block_state(copy.get(), s.box_on_floor, &state) == HS_OK);
  CHECK(hs_world_get_block_state(copy.get(), s.box_away, &state) == HS_ERROR_STALE_ID);
  const hs_block one = add_block(s.context.get(), s.world.get(), box(2, 3, 3, 4), HS_BLOCK_RIGID);
  const hs_block other = add_block(s.context.get(), copy.get(), box(2, 3, 3, 4), HS_BLOCK_RIGID);
  CHECK(one == other);
  REQUIRE(hs_world_step(s.world.get(), 100) == HS_OK);
  REQUIRE(hs_world_step(copy.get(), 100) == HS_OK);
  CHECK(same(saved(s.world.get()), saved(copy.get())));
}

TEST_CASE("bad snapshots are refused") {
  TwoBoxes s;
  REQUIRE(hs_world_step(s.world.get(), 10) == HS_OK);
  hs_context* c = s.context.get();
  hs_world* w = s.world.get();
  const std::vector<unsigned char> good = saved(w);
  std::size_t size = 0;
  std::vector<unsigned char> room(good.size(), 0xee);
  check_refusals(c, "hs_world_save",
                 {{"count", "NULL", [&] { return hs_world_save(w, room.data(), room.size(), nullptr); }},
                  {"bytes", "NULL", [&] { return hs_world_save(w, nullptr, 10, &size); }}});
  CHECK(hs_world_save(nullptr, room.data(), room.size(), &size) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_save(w, room.data(), good.size() - 1, &size) == HS_NOTE_TRUNCATED);
  CHECK(size == good.size());
  CHECK(same(room, std::vector<unsigned char>(good.size(), 0xee)));  // nothing was written

  hs_world* const sentinel = reinterpret_cast<hs_world*>(0x10);
  hs_world* made = sentinel;
  CHECK(hs_world_restore(nullptr, good.data(), good.size(), &made) == HS_ERROR_ARGUMENT);
  check_refusals(c, "hs_world_restore",
                 {{"bytes", "NULL", [&] { return hs_world_restore(c, nullptr, good.size(), &made); }},
                  {"world", "NULL", [&] { return hs_world_restore(c, good.data(), good.size(), nullptr); }}});
  for (std::size_t length = 0; length < good.size(); length += 1 + length / 50) {
    INFO("cut off after " << length << " of " << good.size() << " bytes");
    CHECK(hs_world_restore(c, good.data(), length, &made) == HS_ERROR_FORMAT);
  }
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<unsigned char> flipped = good;
    flipped[i] ^= static_cast<unsigned char>(1u << (i % 8));
    INFO("one bit flipped in byte " << i);
    CHECK(hs_world_restore(c, flipped.data(), flipped.size(), &made) == HS_ERROR_FORMAT);
  }
  std::vector<unsigned char> longer = good;
  longer.push_back(0);
  CHECK(hs_world_restore(c, longer.data(), longer.size(), &made) == HS_ERROR_FORMAT);
  CHECK(made == sentinel);
}

}  // namespace halfspace_test
