#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "halfspace/share.h"
#include "sized_struct.h"
#include "world/share/assembly.h"
#include "world/share/shared_step.h"
#include "world/share/shared_world.h"
#include "world/snapshot.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

constexpr std::size_t ledger_count = sizeof(EnergyLedger::Sums) / sizeof(double);
static_assert(ledger_count + 6 == HS_SUM_COUNT);
static_assert(int(ShareRole::own) == HS_ROLE_OWN && int(ShareRole::everywhere) == HS_ROLE_EVERYWHERE);

/// Refuses what shares cannot hold.
template <int D>
void require_shareable(const World<D>& w) {
  const Model<D>& model = w.model();
  const char* found = nullptr;
  if (!w.blocks().meshes().bodies().empty()) found = "meshes";
  if (!w.blocks().bonds().empty()) found = "bonds of bond.h";
  if (!w.blocks().compounds().empty()) found = "compounds";
  if (!model.bolts.empty()) found = "bolts";
  if (model.actions.any([](const Action<D>& action) { return action.kind == ActionKind::servo; }))
    found = "servos";
  if (model.settings.sleep_tolerance > 0) found = "sleep";
  if (model.materials.laws().knows_no_spring()) found = "laws without springs";
  if (found) refuse(HS_ERROR_STATE, "the world has %s, which shares cannot hold", found);
  if (!(model.settings.time_step > 0))
    refuse(HS_ERROR_STATE, "the world has no given time step; shares need one, which is the same in all");
}

template <int D>
ShareRole role_of(const World<D>& w, std::size_t slot) {
  return w.blocks().moves_freely(slot) ? w.state().share.role_of(slot) : ShareRole::everywhere;
}

template <int D>
std::int32_t load_length_of(const World<D>& w) {
  return (D == 2 ? 3 : 6) + (w.model().materials.any_elastic() ? D * D : 0);
}

/// The slot of a key whose block has a role for which `is_right` holds. `last`: the slot that was found last.
template <int D, class IsRight>
std::size_t slot_of_key(const World<D>& w, const std::int64_t keys[], std::int64_t i, const char* wanted,
                        IsRight is_right, std::size_t& last) {
  const std::int32_t slot = living_slot_of(w.state(), keys[i], last);
  if (slot < 0 || !is_right(role_of(w, std::size_t(slot)))) {
    refuse(HS_ERROR_STALE_ID, "keys[%lld] is %lld; no %s has that key", static_cast<long long>(i),
           static_cast<long long>(keys[i]), wanted);
  }
  return last = std::size_t(slot);
}

void require_piece(bool is_right, const char* wanted) {
  if (!is_right) refuse(HS_ERROR_STATE, "the step is not at this piece; call %s first", wanted);
}

template <int D>
void require_loads_computed(const World<D>& w) {
  const ShareStage stage = w.state().share.stage();
  require_piece(stage == ShareStage::begun || stage == ShareStage::moved,
                "hs_world_begin() or hs_world_move()");
}

template <int D>
SharedStep<D> shared_step(World<D>& w) {
  return {w.state(), w.stages()};
}

hs_share_plan plan_of(const SharedMotion& motion) {
  const hs_status refusal = motion.result == StepResult::ok         ? HS_OK
                            : motion.result == StepResult::too_fast ? HS_ERROR_TOO_FAST
                                                                    : HS_ERROR_UNSTABLE;
  return {motion.needs_list, motion.needs_assembly, refusal, 0};
}

[[noreturn]] void refuse_assembly(const AssemblyFault& fault, std::span<const PackedBlock> blocks) {
  const auto i = static_cast<long long>(fault.block);
  const auto key = static_cast<long long>(blocks.empty() ? -1 : blocks[fault.block].key);
  switch (fault.kind) {
    case AssemblyFault::unknown_block:
      refuse(HS_ERROR_STALE_ID, "blocks[%lld] has key %lld and no bytes; it is no own block of from", i, key);
    case AssemblyFault::unknown_outline:
      refuse(HS_ERROR_STALE_ID, "blocks[%lld] has key %lld and bytes without a shape; from has no such block",
             i, key);
    case AssemblyFault::wrong_role:
      refuse(
          HS_ERROR_ARGUMENT,
          "blocks[%lld].role is %d; fixed and prescribed blocks are everywhere, all others own or neighbours",
          i, int(blocks[fault.block].role));
    case AssemblyFault::other_step:
      refuse(HS_ERROR_ARGUMENT, "blocks[%lld].bytes are of another step than from, or of another world", i);
    case AssemblyFault::damaged_record:
      refuse(HS_ERROR_FORMAT, "blocks[%lld].bytes do not hold the record of a block with key %lld", i, key);
    default:
      refuse(HS_ERROR_FORMAT, "the bytes of the blocks do not hold a valid state of a world");
  }
}

/// Each share has all blocks that are everywhere.
template <int D>
void require_all_everywhere(const World<D>& from, std::span<const PackedBlock> blocks) {
  const auto is_everywhere = [](const PackedBlock& block) { return block.role == ShareRole::everywhere; };
  std::int64_t here = 0;
  for_each_block(from.blocks(), [&](std::int64_t, std::int32_t slot) {
    here += !from.blocks().moves_freely(std::size_t(slot));
  });
  const std::int64_t given = std::count_if(blocks.begin(), blocks.end(), is_everywhere);
  if (given != here)
    refuse(HS_ERROR_ARGUMENT, "blocks has %lld blocks that are everywhere; from has %lld, and needs all",
           static_cast<long long>(given), static_cast<long long>(here));
}

std::span<const std::byte> bytes_of(const hs_packed& block) {
  return {static_cast<const std::byte*>(block.bytes), block.bytes ? block.size : 0};
}

template <int D>
hs_world* assemble(hs_context* context, World<D>& from, const hs_packed blocks[], std::int64_t count) {
  require_shareable(from);
  require_between_steps(from);
  Array<PackedBlock> packed(&context->memory);
  packed.reserve(std::size_t(count));
  for (std::int64_t i = 0; i < count; ++i) {
    const hs_packed& block = blocks[i];
    const auto at = static_cast<long long>(i);
    if (i > 0 && block.key <= blocks[i - 1].key) {
      refuse(HS_ERROR_ARGUMENT, "blocks[%lld].key is %lld; it must be above that of the block before", at,
             static_cast<long long>(block.key));
    }
    if (block.role < HS_ROLE_OWN || block.role > HS_ROLE_EVERYWHERE)
      refuse(HS_ERROR_ARGUMENT, "blocks[%lld].role is %d; it must be an HS_ROLE_ value", at, block.role);
    if (!block.bytes && block.size > 0)
      refuse(HS_ERROR_ARGUMENT, "blocks[%lld].bytes is NULL, but their size is %zu", at, block.size);
    packed.push_back({block.key, ShareRole(block.role), bytes_of(block)});
  }
  WorldHandle<D>* share = create<WorldHandle<D>>(context, context, WorldSettings<D>());
  try {
    const AssemblyFault fault = assemble(share->world, from, packed);
    if (fault.kind != AssemblyFault::none) refuse_assembly(fault, packed);
    require_all_everywhere(from, packed);
  } catch (...) {
    destroy(context, share);
    throw;
  }
  return share;
}

}  // namespace

hs_status hs_world_set_keys(hs_world* world, const int64_t keys[], int64_t count) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_whole(w, "its keys are those that it was assembled with");
    if (count != w.blocks().count()) {
      refuse(HS_ERROR_ARGUMENT, "count is %lld; the world has %lld blocks", static_cast<long long>(count),
             static_cast<long long>(w.blocks().count()));
    }
    if (count > 0) require_pointer(keys, "keys");
    for (std::int64_t i = 1; i < count; ++i) {
      if (keys[i] <= keys[i - 1]) {
        refuse(HS_ERROR_ARGUMENT, "keys[%lld] is %lld; it must be above the key before",
               static_cast<long long>(i), static_cast<long long>(keys[i]));
      }
    }
    set_keys(w.state(), {keys, std::size_t(count)});
    return HS_OK;
  });
}

hs_status hs_world_get_keys(const hs_world* world, int64_t keys[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(keys, "keys");
    return write_blocks(w.blocks(), capacity, count,
                        [&](std::int64_t i, std::size_t s) { keys[i] = w.state().share.key_of(s); });
  });
}

hs_status hs_world_get_roles(const hs_world* world, int32_t roles[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(roles, "roles");
    return write_blocks(w.blocks(), capacity, count,
                        [&](std::int64_t i, std::size_t s) { roles[i] = std::int32_t(role_of(w, s)); });
  });
}

hs_status hs_world_get_share_info(hs_world* world, hs_share_info* info, size_t size) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(info, "info");
    require_report_size(size, offsetof(hs_share_info, halo) + sizeof(double));
    std::int64_t of_role[3] = {};
    for_each_block(w.blocks(),
                   [&](std::int64_t, std::int32_t slot) { ++of_role[int(role_of(w, std::size_t(slot)))]; });
    const hs_share_info ours{of_role[HS_ROLE_OWN],
                             of_role[HS_ROLE_NEIGHBOR],
                             of_role[HS_ROLE_EVERYWHERE],
                             w.state().share.lost_pairs(),
                             load_length_of(w),
                             w.state().share.is_whole(),
                             halo(w.state()),
                             common_of_shares(w.state()).blocks};
    write_sized(ours, info, size);
    return HS_OK;
  });
}

hs_status hs_world_pack(hs_world* world, const int64_t keys[], int64_t count, int32_t with_shapes,
                        void* bytes, size_t capacity, size_t ends[], size_t* needed) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_count(count, "count");
    if (count > 0) require_pointer(keys, "keys");
    require_pointer(needed, "needed");
    if (capacity > 0) require_pointer(bytes, "bytes");
    if (with_shapes != 0 && with_shapes != 1)
      refuse(HS_ERROR_ARGUMENT, "with_shapes is %d; it must be 0 or 1", with_shapes);
    require_between_steps(w);
    BlockRecord<D> record(&world->context->memory);
    const auto for_each_record = [&](auto use) {
      std::size_t last = 0;
      for (std::int64_t i = 0; i < count; ++i) {
        write_record(w.state(),
                     slot_of_key(
                         w, keys, i, "own block and none that is everywhere",
                         [](ShareRole role) { return role != ShareRole::neighbor; }, last),
                     with_shapes != 0, record);
        use(i);
      }
    };
    snapshot::Writer counter(nullptr);
    for_each_record([&](std::int64_t) { counter(record); });
    *needed = counter.size();
    const bool fits = counter.size() <= capacity;
    if (!fits && !ends) return HS_NOTE_TRUNCATED;
    // From here on the record has all its memory. Without room only the ends are written.
    snapshot::Writer writer(fits ? static_cast<std::byte*>(bytes) : nullptr);
    for_each_record([&](std::int64_t i) {
      writer(record);
      if (ends) ends[i] = writer.size();
    });
    return fits ? HS_OK : HS_NOTE_TRUNCATED;
  });
}

hs_status hs_world_assemble(hs_context* context, hs_world* from, const hs_packed blocks[], int64_t count,
                            hs_world** share) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(from, "from");
    require_pointer(share, "share");
    require_count(count, "count");
    if (count > 0) require_pointer(blocks, "blocks");
    *share = visit(*from, [&]<int D>(World<D>& w) { return assemble(context, w, blocks, count); });
    return HS_OK;
  });
}

hs_status hs_world_get_sums(const hs_world* world, double sums[]) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(sums, "sums");
    const auto ledger = std::bit_cast<std::array<double, ledger_count>>(w.state().ledger.sums());
    const Momentum<D> momentum = momentum_of(w.state());
    write_vector(momentum.linear, std::copy(ledger.begin(), ledger.end(), sums));
    write_angular(momentum.angular, sums + ledger_count + 3);
    return HS_OK;
  });
}

hs_status hs_world_set_sums(hs_world* world, const double sums[]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(sums, "sums");
    std::array<double, ledger_count> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!std::isfinite(sums[i]))
        refuse(HS_ERROR_ARGUMENT, "sums[%zu] is %g; it must be finite", i, sums[i]);
      all[i] = sums[i];
    }
    set_ledger_sums(w.state(), std::bit_cast<EnergyLedger::Sums>(all));
    return HS_OK;
  });
}

hs_status hs_world_begin(hs_world* world) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_shareable(w);
    require_piece(w.state().share.stage() != ShareStage::moved, "hs_world_end_step()");
    require_copies_in_place(w);
    const StepResult result = shared_step(w).begin();
    if (result != StepResult::ok) refuse(HS_ERROR_STATE, "the world has no time step");
    w.state().share.enter(ShareStage::begun);
    return HS_OK;
  });
}

hs_status hs_world_end_begin(hs_world* world) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_piece(w.state().share.stage() == ShareStage::begun, "hs_world_begin()");
    if (w.state().is_edited()) shared_step(w).end_beginning();
    w.state().share.enter(ShareStage::ready);
    return HS_OK;
  });
}

hs_status hs_world_plan_motion(hs_world* world, hs_share_plan* plan) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(plan, "plan");
    require_shareable(w);
    require_between_steps(w);
    require_piece(!w.state().is_edited() && !w.state().contacts.has_new_blocks(),
                  "hs_world_begin() and hs_world_end_begin()");
    *plan = plan_of(shared_step(w).predict());
    return HS_OK;
  });
}

hs_status hs_world_renew_list(hs_world* world, hs_share_plan* plan) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(plan, "plan");
    require_piece(w.state().share.stage() == ShareStage::planned, "hs_world_plan_motion()");
    *plan = plan_of(shared_step(w).renew_list());
    return HS_OK;
  });
}

hs_status hs_world_move(hs_world* world) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_piece(w.state().share.stage() == ShareStage::planned, "hs_world_plan_motion()");
    require_piece(!w.state().contacts.neighbors().needs_rebuild(), "hs_world_renew_list()");
    shared_step(w).move();
    w.state().share.enter(ShareStage::moved);
    return HS_OK;
  });
}

hs_status hs_world_get_loads(const hs_world* world, const int64_t keys[], int64_t count, double loads[]) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(count, "count");
    if (count > 0) require_pointer(keys, "keys");
    if (count > 0) require_pointer(loads, "loads");
    require_loads_computed(w);
    const std::int32_t length = load_length_of(w);
    const Blocks<D>& blocks = w.blocks();
    const auto is_own = [](ShareRole role) { return role == ShareRole::own; };
    std::size_t last = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::size_t s = slot_of_key(w, keys, i, "own block", is_own, last);
      double* out = loads + i * length;
      out = std::copy_n(blocks.force[s].data(), D, out);
      out = std::copy_n(blocks.torque[s].data(), blocks.torque[s].size(), out);
      if (out == loads + (i + 1) * length) continue;
      const Tensor<D> virial =
          blocks.is_affine(s) ? blocks.deformation(s).virial : Tensor<D>(Tensor<D>::Zero());
      for (int row = 0; row < D; ++row)
        for (int column = 0; column < D; ++column) *out++ = virial(row, column);
    }
    return HS_OK;
  });
}

hs_status hs_world_set_loads(hs_world* world, const int64_t keys[], int64_t count, const double loads[]) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_count(count, "count");
    if (count > 0) require_pointer(keys, "keys");
    if (count > 0) require_pointer(loads, "loads");
    require_loads_computed(w);
    const std::int32_t length = load_length_of(w);
    const auto is_copy = [](ShareRole role) { return role == ShareRole::neighbor; };
    std::size_t last = 0;
    const auto slot = [&](std::int64_t i) { return slot_of_key(w, keys, i, "copy", is_copy, last); };
    for (std::int64_t i = 0; i < count; ++i) static_cast<void>(slot(i));  // before any changes
    for (std::int64_t i = 0; i < count; ++i) {
      const double* in = loads + i * length;
      const Vector<D> force = Eigen::Map<const Vector<D>>(in);
      in += D;
      const Angular<D> torque = Eigen::Map<const Angular<D>>(in);
      in += torque.size();
      Tensor<D> virial = Tensor<D>::Zero();
      if (in != loads + (i + 1) * length) {
        for (int row = 0; row < D; ++row)
          for (int column = 0; column < D; ++column) virial(row, column) = *in++;
      }
      shared_step(w).set_loads(slot(i), force, torque, virial);
    }
    return HS_OK;
  });
}

hs_status hs_world_end_step(hs_world* world) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_piece(w.state().share.stage() == ShareStage::moved, "hs_world_move()");
    shared_step(w).end();
    w.state().share.enter(ShareStage::ready);
    return HS_OK;
  });
}
