// The functions of halfspace/compound.h as calls on a scene.

#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

/// A box and the round block beside it, apart.
struct TwoParts {
  explicit TwoParts(const Scene& s) : shapes{s.box.get(), s.round.get()} {}

  const hs_shape* shapes[2];
  hs_pose poses[2] = {pose_at(20, 0), pose_at(30, 0)};
};

hs_status init(Scene& s, hs_block_def& def) {
  const TwoParts parts(s);
  return hs_compound_def_init(&def, sizeof def, parts.shapes, parts.poses, 2);
}

hs_status add(Scene& s, hs_block* block) {
  const TwoParts parts(s);
  hs_block_def def;
  const hs_status status = init(s, def);
  if (status != HS_OK) return status;
  return hs_world_add_compound(s.world.get(), parts.shapes, parts.poses, 2, &def, block);
}

void add_beside(Scene& s) { require_ok(add(s, &s.beside), s.context.get()); }

}  // namespace

std::vector<EntryPoint> entry_points_of_compounds() {
  using S = Scene&;
  return {
      {"hs_compound_def_init", Allocates::always,
       [](S s) {
         hs_block_def def;
         return init(s, def);
       }},
      {"hs_world_add_compound", Allocates::always, [](S s) { return add(s, &s.written.blocks[0]); }},
      {"hs_world_get_compound_parts", Allocates::never,
       [](S s) {
         return hs_world_get_compound_parts(s.world.get(), s.beside, s.written.blocks, 4,
                                            &s.written.counts[0]);
       },
       add_beside},
      {"hs_world_get_compound_of_block", Allocates::never,
       [](S s) {
         return hs_world_get_compound_of_block(s.world.get(), s.beside, &s.written.blocks[0],
                                               s.written.indices[0]);
       },
       add_beside},
  };
}

}  // namespace halfspace_test
