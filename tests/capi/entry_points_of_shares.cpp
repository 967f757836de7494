// The functions of halfspace/share.h as calls on a scene.

#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

constexpr std::int64_t keys[] = {0, 1};

void arrange_share(Scene& s) { require_ok(hs_world_set_time_step(s.world.get(), 1e-5), s.context.get()); }
void arrange_begun(Scene& s) {
  arrange_share(s);
  require_ok(hs_world_begin(s.world.get()), s.context.get());
}
void arrange_ready(Scene& s) {
  arrange_begun(s);
  require_ok(hs_world_end_begin(s.world.get()), s.context.get());
}
void arrange_planned(Scene& s) {
  arrange_ready(s);
  hs_share_plan plan;
  require_ok(hs_world_plan_motion(s.world.get(), &plan), s.context.get());
}
void arrange_moved(Scene& s) {
  arrange_planned(s);
  require_ok(hs_world_move(s.world.get()), s.context.get());
}

/// Makes a share of the upper block.
hs_status assemble(Scene& s) {
  const hs_packed blocks[] = {{0, nullptr, 0, HS_ROLE_EVERYWHERE, 0}, {1, nullptr, 0, HS_ROLE_OWN, 0}};
  return keep(s.made.world, [&](hs_world** world) {
    return hs_world_assemble(s.context.get(), s.world.get(), blocks, 2, world);
  });
}

}  // namespace

std::vector<EntryPoint> entry_points_of_shares() {
  using S = Scene&;
  return {
      {"hs_world_set_keys", Allocates::always, [](S s) { return hs_world_set_keys(s.world.get(), keys, 2); }},
      {"hs_world_get_keys", Allocates::never,
       [](S s) { return hs_world_get_keys(s.world.get(), s.written.counts, 2, nullptr); }},
      {"hs_world_get_roles", Allocates::never,
       [](S s) { return hs_world_get_roles(s.world.get(), s.written.indices[0], 2, &s.written.counts[0]); }},
      {"hs_world_get_share_info", Allocates::always,
       [](S s) { return hs_world_get_share_info(s.world.get(), &s.written.share, sizeof s.written.share); }},
      {"hs_world_pack", Allocates::always,
       [](S s) {
         return hs_world_pack(s.world.get(), keys, 2, 1, s.written.packed, sizeof s.written.packed, nullptr,
                              &s.written.size);
       },
       arrange_ready},
      {"hs_world_assemble", Allocates::always, assemble, arrange_ready},
      {"hs_world_get_sums", Allocates::never,
       [](S s) { return hs_world_get_sums(s.world.get(), s.written.vectors[0][0]); }},
      {"hs_world_set_sums", Allocates::never,
       [](S s) { return hs_world_set_sums(s.world.get(), s.written.vectors[0][0]); }},
      {"hs_world_begin", Allocates::always, [](S s) { return hs_world_begin(s.world.get()); }, arrange_share},
      {"hs_world_end_begin", Allocates::never, [](S s) { return hs_world_end_begin(s.world.get()); },
       arrange_begun},
      {"hs_world_plan_motion", Allocates::always,
       [](S s) { return hs_world_plan_motion(s.world.get(), &s.written.plan); }, arrange_ready},
      {"hs_world_renew_list", Allocates::always,
       [](S s) { return hs_world_renew_list(s.world.get(), &s.written.plan); }, arrange_planned},
      {"hs_world_move", Allocates::never, [](S s) { return hs_world_move(s.world.get()); }, arrange_planned},
      {"hs_world_get_loads", Allocates::never,
       [](S s) { return hs_world_get_loads(s.world.get(), keys + 1, 1, s.written.vectors[0][0]); },
       arrange_moved},
      {"hs_world_set_loads", Allocates::never,
       [](S s) { return hs_world_set_loads(s.world.get(), keys, 0, nullptr); }, arrange_moved},
      {"hs_world_end_step", Allocates::never, [](S s) { return hs_world_end_step(s.world.get()); },
       arrange_moved},
  };
}

}  // namespace halfspace_test
