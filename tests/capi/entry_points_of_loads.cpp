// The functions of halfspace/water.h and bolt.h as calls on a scene.

#include "capi/entry_points.h"
#include "capi/loads.h"

namespace halfspace_test {
namespace {

hs_status bolt(Scene& s) {
  const hs_bolt_def def = bolt_def(s.lower, {0, 0, 0}, s.upper, {0.1, 1, 0.1}, 1e6);
  return hs_world_add_bolt(s.world.get(), &def, &s.written.counts[0]);
}

hs_status flood(Scene& s) {
  const Points3 table{{0, 0.5, 0.5}};
  const hs_water_def def = water_def();
  return hs_world_set_water(s.world.get(), &def, view_of(table));
}

void arrange_bolt(Scene& s) { require_ok(bolt(s), s.context.get()); }
void arrange_water(Scene& s) { require_ok(flood(s), s.context.get()); }
/// The list of pairs stays while the water comes.
void detect_and_flood(Scene& s) {
  require_ok(hs_world_detect(s.world.get(), nullptr), s.context.get());
  arrange_water(s);
  require_ok(hs_world_detect(s.world.get(), nullptr), s.context.get());
}

}  // namespace

std::vector<EntryPoint> entry_points_of_loads() {
  using S = Scene&;
  return {
      {"hs_water_def_init", Allocates::never, [](S) { return fill<hs_water_def>(hs_water_def_init); }},
      {"hs_world_set_water", Allocates::always, flood},
      {"hs_world_get_water_loads", Allocates::always,
       [](S s) { return hs_world_get_water_loads(s.world.get(), room(s, 0), room(s, 1)); }, arrange_water},
      {"hs_world_forces", Allocates::never,
       [](S s) { return hs_world_forces(s.world.get(), 1e-5, room(s, 0), room(s, 1)); }, detect_and_flood},
      {"hs_bolt_def_init", Allocates::never, [](S) { return fill<hs_bolt_def>(hs_bolt_def_init); }},
      {"hs_world_add_bolt", Allocates::always, bolt},
      {"hs_world_remove_bolt", Allocates::never, [](S s) { return hs_world_remove_bolt(s.world.get(), 0); },
       arrange_bolt},
      {"hs_world_get_bolts", Allocates::never,
       [](S s) { return hs_world_get_bolts(s.world.get(), s.written.bolts, 2, &s.written.counts[0]); },
       arrange_bolt},
      {"hs_world_get_block_at", Allocates::never,
       [](S s) {
         const double place[3] = {0, 0, 0};
         return hs_world_get_block_at(s.world.get(), place, &s.written.blocks[0]);
       }},
  };
}

}  // namespace halfspace_test
