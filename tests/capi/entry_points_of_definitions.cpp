// The functions of halfspace/definition.h and check.h as calls on a scene.

#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

void add_action(Scene& s) {
  const double time = 0;
  const Points3 value = {{1, 2, 0}};
  std::int32_t table = -1;
  require_ok(hs_world_add_table(s.world.get(), &time, view_of(value), &table), s.context.get());
  hs_action_def def;
  require_ok(hs_action_def_init(&def, sizeof def), s.context.get());
  require_ok(hs_world_add_action(s.world.get(), s.upper, &def), s.context.get());
}

}  // namespace

std::vector<EntryPoint> entry_points_of_definitions() {
  using S = Scene&;
  return {
      {"hs_world_get_def", Allocates::never,
       [](S s) {
         hs_world_def def;
         return hs_world_get_def(s.world.get(), &def, sizeof def);
       }},
      {"hs_world_get_densities", Allocates::never,
       [](S s) {
         return hs_world_get_densities(s.world.get(), s.written.vectors[0][0], 3, &s.written.counts[0]);
       }},
      {"hs_world_get_elasticity", Allocates::never,
       [](S s) {
         hs_elasticity_def def;
         return hs_world_get_elasticity(s.world.get(), 0, &def, sizeof def);
       }},
      {"hs_world_get_default_law", Allocates::never,
       [](S s) {
         hs_law_def def;
         return hs_world_get_default_law(s.world.get(), &def, sizeof def);
       }},
      {"hs_world_get_law", Allocates::never,
       [](S s) {
         hs_law_def def;
         return hs_world_get_law(s.world.get(), 0, 0, &def, sizeof def);
       }},
      {"hs_world_get_table", Allocates::never,
       [](S s) {
         double times[128];
         return hs_world_get_table(s.world.get(), 0, times, room(s, 0), &s.written.counts[0]);
       },
       add_action},
      {"hs_world_get_actions", Allocates::never,
       [](S s) {
         hs_action_def def;
         return hs_world_get_actions(s.world.get(), s.upper, &def, sizeof def, 1, &s.written.counts[0]);
       },
       add_action},
      {"hs_setting_get_usual", Allocates::never,
       [](S s) {
         double* const range = s.written.vectors[0][0];
         return hs_setting_get_usual(HS_SETTING_DENSITY, &range[0], &range[1]);
       }},
      {"hs_setting_usual_text", Allocates::never,
       [](S) { return hs_setting_usual_text(HS_SETTING_DENSITY) ? HS_OK : HS_ERROR_INTERNAL; }},
      {"hs_world_check", Allocates::never,
       [](S s) { return hs_world_check(s.world.get(), s.written.notes, 2, &s.written.counts[0]); }},
  };
}

}  // namespace halfspace_test
