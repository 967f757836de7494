#include "shares/row.h"

// Energies, losses and momentum of shares add up to those of the whole world.

using namespace halfspace_test;

TEST_CASE("sums have the momentum about the origin, and setting them does not change it", "[shares]") {
  const Row row;
  const double velocity[] = {2, 3, 0}, spin[] = {0, 0, 4};
  require_ok(hs_world_set_velocity(row.world.get(), row.boxes[2], velocity, spin), row.context.get());
  double sums[HS_SUM_COUNT], after[HS_SUM_COUNT];
  require_ok(hs_world_get_sums(row.world.get(), sums), row.context.get());
  // A square of 2000 kg with its centroid at (2.5, 0.5): m v, and m (x v_y - y v_x) + m a^2 / 6 w.
  const double expected[] = {4000, 6000, 0, 0, 0, 2000 * (2.5 * 3 - 0.5 * 2) + 2000.0 / 6 * 4};
  for (int i = 0; i < 6; ++i) CHECK(sums[21 + i] == Approx(expected[i]).epsilon(1e-14));
  sums[0] = 7;
  sums[26] = HUGE_VAL;
  require_ok(hs_world_set_sums(row.world.get(), sums), row.context.get());
  require_ok(hs_world_get_sums(row.world.get(), after), row.context.get());
  CHECK(after[0] == 7);
  CHECK(after[26] == Approx(expected[5]).epsilon(1e-14));
}

TEST_CASE("losses stay with a share that comes to own all blocks", "[shares]") {
  const Row row;
  hs_context* const context = row.context.get();
  constexpr int friction = 3;
  const auto loss_of = [](const World& world) {
    double sums[HS_SUM_COUNT];
    require_ok(hs_world_get_sums(world.get(), sums), nullptr);
    return sums[friction];
  };
  const auto set_loss = [&](const World& world, double loss) {
    double sums[HS_SUM_COUNT] = {};
    sums[friction] = loss;
    require_ok(hs_world_set_sums(world.get(), sums), context);
  };
  const auto cut = [&](const World& from, const std::vector<hs_packed>& blocks) {
    hs_world* share = nullptr;
    require_ok(hs_world_assemble(context, from.get(), blocks.data(), std::int64_t(blocks.size()), &share),
               context);
    return World(share);
  };
  set_loss(row.world, 5);
  const World a = cut(row.world, {part(0, HS_ROLE_EVERYWHERE), part(1, HS_ROLE_OWN), part(2, HS_ROLE_OWN)});
  const World b = cut(row.world, {part(0, HS_ROLE_EVERYWHERE), part(3, HS_ROLE_OWN), part(4, HS_ROLE_OWN)});
  set_loss(a, 1);
  set_loss(b, 2);
  const Records records = packed(context, a.get(), {1, 2}, true);
  const World all =
      cut(b, {part(0, HS_ROLE_EVERYWHERE),
              {1, records.bytes.data(), records.ends[0], HS_ROLE_OWN, 0},
              {2, records.bytes.data() + records.ends[0], records.ends[1] - records.ends[0], HS_ROLE_OWN, 0},
              part(3, HS_ROLE_OWN),
              part(4, HS_ROLE_OWN)});
  const World none = cut(a, {part(0, HS_ROLE_EVERYWHERE)});
  CHECK(loss_of(none) + loss_of(all) == 3);
  CHECK(info_of(all.get()).is_whole == 1);
  CHECK(loss_of(all) == 2);
  const std::vector<hs_packed> first = {part(0, HS_ROLE_EVERYWHERE), part(1, HS_ROLE_OWN)},
                               last = {part(0, HS_ROLE_EVERYWHERE), part(4, HS_ROLE_OWN)};
  CHECK(loss_of(cut(all, last)) == 2);
  CHECK(loss_of(cut(restored(context, saved(all.get())), last)) == 2);
  // A world with the losses of all is a whole one, and its shares divide them.
  set_loss(all, 3);
  CHECK(loss_of(cut(all, last)) == 0);
  CHECK(loss_of(cut(all, first)) == 3);
  // One of several shares may own all blocks from the first cut on.
  const World alone = cut(row.world, {part(0, HS_ROLE_EVERYWHERE), part(1, HS_ROLE_OWN), part(2, HS_ROLE_OWN),
                                      part(3, HS_ROLE_OWN), part(4, HS_ROLE_OWN)});
  CHECK(loss_of(alone) == loss_of(row.world));
  CHECK(loss_of(cut(alone, last)) == loss_of(row.world));
}

TEST_CASE("reports count energies once between a change and the beginning", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  SplitWorld split(start, 2);
  for (int i = 0; i < 100; ++i) split.step();
  // The first share takes over all blocks, whose energies are still in the sums of the second.
  const std::vector<std::int64_t> moved = keys_with(split.world(1), HS_ROLE_OWN);
  const Records records = packed(split.context(), split.world(1), moved, true);
  std::vector<hs_packed> all;
  for (const std::int64_t key : keys_with(split.world(0), HS_ROLE_OWN)) all.push_back(part(key, HS_ROLE_OWN));
  for (std::size_t i = 0; i < moved.size(); ++i)
    all.push_back({moved[i], records.bytes.data() + records.begin_of(i),
                   records.ends[i] - records.begin_of(i), HS_ROLE_OWN, 0});
  for (const std::int64_t key : keys_with(whole.get(), HS_ROLE_EVERYWHERE))
    all.push_back(part(key, HS_ROLE_EVERYWHERE));
  std::sort(all.begin(), all.end(), [](const hs_packed& a, const hs_packed& b) { return a.key < b.key; });
  hs_world* made = nullptr;
  require_ok(hs_world_assemble(split.context(), split.world(0), all.data(), std::int64_t(all.size()), &made),
             split.context());
  const World owner(made);
  CHECK(info_of(made).is_whole == 1);
  const auto kinetic = [&] {
    return report_of(made).energy.kinetic + report_of(split.world(1)).energy.kinetic;
  };
  const double before = kinetic();
  CHECK(before > 0);
  require_ok(hs_world_set_time_step(made, 4e-5), split.context());
  CHECK(kinetic() == before);
  require_ok(hs_world_begin(made), split.context());
  require_ok(hs_world_end_begin(made), split.context());
  CHECK(report_of(made).energy.kinetic == Approx(before).epsilon(1e-12));
}

TEST_CASE("the momentum of shares adds up to the rounding of their sums", "[shares]") {
  SplitWorld split(heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID, 1600), 3);
  for (int i = 0; i < 10; ++i) split.step();
  double whole[HS_SUM_COUNT], own[HS_SUM_COUNT], sums[HS_SUM_COUNT] = {}, sizes[HS_SUM_COUNT] = {};
  for (std::size_t s = 0; s < split.count(); ++s) {
    require_ok(hs_world_get_sums(split.world(s), own), split.context());
    for (int i = 0; i < HS_SUM_COUNT; ++i) {
      sums[i] += own[i];
      sizes[i] += std::abs(own[i]);
    }
  }
  const World joined = split.joined();
  require_ok(hs_world_get_sums(joined.get(), whole), split.context());
  for (const int i : {21, 22, 26})
    CHECK(std::abs(sums[i] - whole[i]) <= 2 * std::numeric_limits<double>::epsilon() * sizes[i]);
}
