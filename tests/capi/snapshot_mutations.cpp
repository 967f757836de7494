// Snapshots whose checksum is right and whose content is not: restoring gives HS_ERROR_FORMAT or a world that
// runs. What must not happen is seen best under the address sanitizer.

#include <cmath>
#include <limits>

#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// One number becomes another, of the kinds that lead programs astray.
void change_number(std::vector<unsigned char>& bytes, std::size_t place, Random& random) {
  constexpr double numbers[] = {0,    -1,    1,      1e-310,   1e-60,
                                1e60, 1e300, -1e300, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()};
  constexpr std::int32_t whole_numbers[] = {0,   1,    2,  3,  4,       7,         64,
                                            127, 4095, -1, -2, 1 << 20, INT32_MAX, INT32_MIN};
  const std::int32_t whole_number = whole_numbers[random() % std::size(whole_numbers)];
  switch (random() % 7) {
    case 0:
      bytes[place + random() % 4] ^= static_cast<unsigned char>(1u << random() % 8);
      break;
    case 1:
      put(bytes, place, numbers[random() % std::size(numbers)]);
      break;
    case 2:
      put(bytes, place, whole_number);
      break;
    case 3:
      put(bytes, place, std::int64_t(whole_number));
      break;
    case 4:
      put(bytes, place, at<std::uint32_t>(bytes, place) + (random() % 2 ? 1u : ~0u));
      break;
    case 5:
      put(bytes, place + 2 * (random() % 2), std::int16_t(random() % 64));
      break;
    default: {  // what stands elsewhere
      const std::size_t from = snapshot_header + 4 * (random() % ((bytes.size() - snapshot_header) / 4 - 1));
      std::memmove(bytes.data() + place, bytes.data() + from, 8);
    }
  }
}

/// What may be the count of an array goes up or down, and so much is inserted or taken out behind it.
void change_length(std::vector<unsigned char>& bytes, Random& random) {
  constexpr std::size_t sizes[] = {1, 2, 4, 8, 16, 24, 32, 40, 48, 64, 72, 120};
  for (int tries = 0; tries < 1000; ++tries) {
    const std::size_t place = snapshot_header + 4 * (random() % ((bytes.size() - snapshot_header) / 4 - 1));
    const auto count = at<std::uint64_t>(bytes, place);
    if (count == 0 || count > 1000) continue;
    const std::size_t size = sizes[random() % std::size(sizes)], behind = place + 8;
    const std::uint64_t fewer[] = {0, 1, count / 2, count - 1}, wanted = fewer[random() % 4];
    const std::size_t all = std::size_t(count) * size;
    if (random() % 3 == 0) {
      bytes.insert(bytes.begin() + std::ptrdiff_t(behind), size, 0);
      put(bytes, place, count + 1);
      return;
    }
    if (behind + all > bytes.size()) continue;
    const auto last = bytes.begin() + std::ptrdiff_t(behind + all);
    bytes.erase(last - std::ptrdiff_t((count - wanted) * size), last);
    put(bytes, place, wanted);
    return;
  }
}

void mutate(std::vector<unsigned char>& bytes, Random& random) {
  if (random() % 4 == 0) return change_length(bytes, random);
  const std::size_t words = (bytes.size() - snapshot_header) / 4;
  // Often among what stands last: time, counts of steps, and what is known.
  const std::size_t word = random() % 8 ? random() % (words - 1) : words - 2 - random() % 40;
  change_number(bytes, snapshot_header + 4 * word, random);
}

/// Reads them, relaxes and weakens the world, and takes the bodies out.
void read_bodies_and_bonds(hs_world* world) {
  hs_bond bonds[8];
  hs_bond_event events[8];
  CHECK(hs_world_get_bonds(world, bonds, 8, nullptr) >= HS_OK);
  CHECK(hs_world_get_bond_events(world, 0, events, 8, nullptr) >= HS_OK);
  hs_bond_report report;
  CHECK(hs_world_get_bond_report(world, &report, sizeof report) == HS_OK);
  CHECK(hs_world_set_strength_factor(world, 2) == HS_OK);
  const hs_relaxation_def def = relaxation_def(2, 1e-9);
  (void)hs_world_relax(world, &def, nullptr, 0);
  hs_block blocks[64];
  std::int64_t count = 0;
  CHECK(hs_world_get_blocks(world, blocks, 64, &count) >= HS_OK);
  Points3 nodes(32);
  for (std::int64_t i = 0; i < std::min(count, std::int64_t(64)); ++i) {
    hs_body body = 0;
    std::int32_t cell = -1;
    if (hs_world_get_body_of_block(world, blocks[i], &body, &cell) != HS_OK || body == 0) continue;
    hs_body_state state;
    hs_cell_state cells[4];
    if (hs_world_get_body_state(world, body, &state, sizeof state) != HS_OK) continue;
    CHECK(hs_world_get_cells(world, body, cells, 4, nullptr) >= HS_OK);
    for (const auto get :
         {hs_world_get_node_positions, hs_world_get_node_velocities, hs_world_get_node_forces})
      CHECK(get(world, body, mutable_view_of(nodes), nullptr) >= HS_OK);
    constexpr std::int32_t first_cell = 0;
    (void)hs_world_remove_cells(world, body, &first_cell, 1, {});
    CHECK(hs_world_remove_body(world, body) == HS_OK);
  }
  (void)hs_world_step(world, 1);
}

/// What reads and writes most of a world.
void run_for_a_while(hs_context* context, hs_world* world) {
  std::vector<hs_contact> contacts(64);
  const hs_status status = hs_world_step(world, 3);
  INFO(hs_status_string(status) << ": " << hs_context_last_error(context));
  CHECK((status == HS_OK || status == HS_ERROR_UNSTABLE || status == HS_ERROR_TOO_FAST ||
         status == HS_ERROR_STATE || status == HS_ERROR_INVERTED));
  CHECK(hs_world_get_contacts(world, contacts.data(), std::int64_t(contacts.size()), nullptr) >= HS_OK);
  hs_world_report report;
  (void)hs_world_get_report(world, &report, sizeof report);
  read_bodies_and_bonds(world);
  saved(world);
}

struct Tally {
  long restored = 0, refused = 0;
};

void restore_mutated(const WorldKind& kind, int mutations, Tally& tally) {
  const Context context = make_context();
  const std::vector<unsigned char> good = snapshot_of(context.get(), kind);
  Random random(std::uint64_t(100 * kind.dimension + 10 * kind.law + kind.block));
  for (int i = 0; i < mutations; ++i) {
    std::vector<unsigned char> bytes = good;
    for (std::uint64_t k = 1 + random() % 3; k > 0; --k) mutate(bytes, random);
    mend_header(bytes);
    hs_world* made = nullptr;
    const hs_status status = hs_world_restore(context.get(), bytes.data(), bytes.size(), &made);
    const World world(made);
    INFO(kind.dimension << "D, law " << kind.law << ", blocks of kind " << kind.block << ", mutation " << i);
    CHECK((status == HS_OK || status == HS_ERROR_FORMAT));
    ++(status == HS_OK ? tally.restored : tally.refused);
    if (status == HS_OK) run_for_a_while(context.get(), world.get());
  }
}

}  // namespace

TEST_CASE("whatever a snapshot holds, it is refused or gives a world that runs") {
  Tally tally;
  for (const int dimension : {2, 3})
    for (const std::int32_t law : all_laws)
      for (const std::int32_t block : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH})
        restore_mutated({dimension, law, block}, 500, tally);
  std::printf("mutated snapshots: %ld restored, %ld refused\n", tally.restored, tally.refused);
  CHECK(tally.restored > 1000);
  CHECK(tally.refused > 1000);
}

}  // namespace halfspace_test
