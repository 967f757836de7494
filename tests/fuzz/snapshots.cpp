// Snapshots whose checksum is right and whose content is not: restoring gives HS_ERROR_FORMAT or a world that
// runs. The bytes are changes of the snapshot of a small world that is made here, so that they stay of use
// when its form changes. Forces and energies may be wrong in value, and overflow: that is what the checksum
// is for.

#include <array>

#include "capi/full_worlds.h"
#include "fuzz/world_calls.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace_test;
using Snapshot = std::vector<unsigned char>;

constexpr int plain_kinds = 24, full_kinds = 8, share_kinds = 2;

/// Two dimensions, all laws, all kinds of blocks; those of meshes with bonds.
Snapshot plain_snapshot(int index) {
  constexpr std::int32_t blocks[] = {HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH};
  const Context context = make_context();
  return snapshot_of(context.get(), {2 + index / 12, all_laws[index / 3 % 4], blocks[index % 3]});
}

Snapshot made_snapshot(int index) {
  if (index < plain_kinds) return plain_snapshot(index);
  const int full = index - plain_kinds;
  return full < full_kinds ? snapshot_of_full_world(2 + full / 4, all_laws[full % 4])
                           : snapshot_of_share(2 + full - full_kinds);
}

const Snapshot& snapshot_of_kind(int index) {
  static std::array<Snapshot, plain_kinds + full_kinds + share_kinds> snapshots;
  Snapshot& snapshot = snapshots[std::size_t(index)];
  if (snapshot.empty()) snapshot = made_snapshot(index);
  return snapshot;
}

/// Half of the bytes choose worlds of everything, and shares.
int read_kind(Bytes& bytes) {
  const int byte = bytes.byte();
  return byte < 128 ? byte % plain_kinds : plain_kinds + byte % (full_kinds + share_kinds);
}

void change(Snapshot& snapshot, Bytes& bytes) {
  const int form = bytes.below(8);
  const std::size_t place =
      snapshot_header + 4 * (bytes.raw<std::uint16_t>() % ((snapshot.size() - snapshot_header) / 4));
  const auto overwrite = [&](auto value) {
    if (place + sizeof value <= snapshot.size()) put(snapshot, place, value);
  };
  switch (form) {
    case 0:
      return overwrite(bytes.raw<std::int32_t>());
    case 1:
      return overwrite(std::int64_t(bytes.raw<std::int8_t>()));
    case 2:
      return overwrite(std::int32_t(bytes.raw<std::int8_t>()));
    case 3:
      return overwrite(bytes.byte());
    case 4:
      return overwrite(bytes.raw<double>());
    case 5:
      return void(snapshot.insert(snapshot.begin() + std::ptrdiff_t(place), 4 * std::size_t(bytes.below(32)),
                                  bytes.byte()));
    case 6: {
      const std::size_t count = std::min(4 * std::size_t(bytes.below(64)), snapshot.size() - place);
      return void(snapshot.erase(snapshot.begin() + std::ptrdiff_t(place),
                                 snapshot.begin() + std::ptrdiff_t(place + count)));
    }
    default:
      return overwrite(bytes.number());
  }
}

/// Weakens and relaxes a world, and takes out a cell of each of its bodies and then all of them.
void end_bodies(hs_world* world) {
  succeeds_or(hs_world_set_strength_factor(world, 2), {}, "set_strength_factor");
  relax(world, relaxation_def(2, 1e-9));
  for (const hs_block block : blocks_of(world)) {
    hs_body body = 0;
    const hs_status status = hs_world_get_body_of_block(world, block, &body, nullptr);
    if (!succeeds_or(status, {HS_ERROR_STALE_ID}, "get_body_of_block") || body == 0) continue;
    constexpr std::int32_t first_cell = 0;
    succeeds_or(hs_world_remove_cells(world, body, &first_cell, 1, {}),
                {HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT, HS_ERROR_STATE, HS_ERROR_GEOMETRY}, "remove_cells");
    succeeds_or(hs_world_remove_body(world, body), {HS_ERROR_STALE_ID}, "remove_body");
  }
  step(world, 1);
}

/// As far as it goes: shares are packed and moved, other worlds refuse.
void step_in_pieces(hs_world* world) {
  std::vector<std::int64_t> keys(blocks_of(world).size());
  demand(hs_world_get_keys(world, keys.data(), std::int64_t(keys.size()), nullptr) == HS_OK, "keys are told");
  std::size_t needed = 0;
  for (const std::int64_t key : keys) (void)hs_world_pack(world, &key, 1, 1, nullptr, 0, nullptr, &needed);
  hs_share_plan plan;
  (void)hs_world_begin(world);
  (void)hs_world_end_begin(world);
  (void)hs_world_plan_motion(world, &plan);
  (void)hs_world_renew_list(world, &plan);
  (void)hs_world_move(world);
  (void)hs_world_end_step(world);
}

void run(Bytes bytes) {
  Snapshot snapshot = snapshot_of_kind(read_kind(bytes));
  while (!bytes.empty() && snapshot.size() > snapshot_header + 8) change(snapshot, bytes);
  mend_header(snapshot);
  const Context context = make_context();
  hs_world* made = nullptr;
  const hs_status status = hs_world_restore(context.get(), snapshot.data(), snapshot.size(), &made);
  if (!succeeds_or(status, {HS_ERROR_FORMAT}, "restore")) return;
  const World world(made);
  check_motion(made);
  step_in_pieces(made);
  step(made, 3);
  hs_world_report report;
  succeeds_or(hs_world_get_report(made, &report, sizeof report), {}, "get_report");
  end_bodies(made);
  saved(made);
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::run({data, size});
  return 0;
}
