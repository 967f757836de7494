#include "halfspace/reaction.h"
#include "sized_struct.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

static_assert(int(Meeting::corner_and_face) == HS_PAIR_VERTEX_FACE &&
              int(Meeting::edges) == HS_PAIR_EDGE_EDGE);

namespace {

template <int D>
hs_reaction reaction_of(const World<D>& world, const Reaction<D>& reaction) {
  hs_reaction out{};
  out.block_a = id_of(world.blocks(), std::size_t(reaction.a));
  out.block_b = id_of(world.blocks(), std::size_t(reaction.b));
  out.pair_kind = std::int32_t(reaction.meeting);
  out.feature_a = reaction.feature_a;
  out.feature_b = reaction.feature_b;
  write_vector(place_of(reaction.of_a, world.blocks()), out.point);
  write_vector(reaction.normal, out.normal);
  write_vector(reaction.force, out.force);
  out.gap = reaction.gap;
  out.touched_at = reaction.touched_at;
  return out;
}

}  // namespace

hs_status hs_world_get_reactions(const hs_world* world, hs_reaction reactions[], int64_t capacity,
                                 int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(reactions, "reactions");
    const Array<Reaction<D>>& all = w.reactions().all();
    if (count) *count = std::int64_t(all.size());
    for (std::size_t i = 0; i < all.size() && std::int64_t(i) < capacity; ++i)
      reactions[i] = reaction_of(w, all[i]);
    return fits(std::int64_t(all.size()), capacity);
  });
}

hs_status hs_world_get_reaction_report(const hs_world* world, hs_reaction_report* report, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(report, "report");
    require_report_size(size, sizeof(hs_reaction_report));
    hs_reaction_report ours{};
    ours.reaction_count = std::int64_t(w.reactions().all().size());
    ours.touch_count = w.reactions().touches();
    ours.round_count = w.reactions().rounds();
    ours.impact_loss = w.ledger().impact_loss;
    write_sized(ours, report, size);
    return HS_OK;
  });
}
