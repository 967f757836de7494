#include "halfspace/plan.h"
#include "prepared_world.h"
#include "sized_struct.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// Friction acts by a shear spring, or without springs by impulses.
bool has_friction(const ContactLaw& law) {
  return law.resists_shear() || (law.has_no_spring() && (law.tan_friction > 0 || law.bonds()));
}

template <int D>
std::int32_t active_parts(const World<D>& world) {
  const Model<D>& model = world.model();
  const auto some_law = [&](auto condition) { return model.materials.laws().any(condition); };
  std::int32_t parts = 0;
  const auto add = [&](std::int32_t part, bool is_active) { parts |= is_active ? part : 0; };
  add(HS_PART_FRICTION, some_law(has_friction));
  add(HS_PART_BONDS,
      !world.blocks().bonds().empty() || some_law([](const ContactLaw& law) { return law.bonds(); }));
  add(HS_PART_CONTACT_DAMPING, some_law([](const ContactLaw& law) { return law.is_damped(); }));
  add(HS_PART_AREA, some_law([](const ContactLaw& law) { return law.is_per_area(); }));
  add(HS_PART_POTENTIAL, some_law([](const ContactLaw& law) { return law.is_potential(); }));
  add(HS_PART_HARD_CONTACTS, some_law([](const ContactLaw& law) { return law.has_no_spring(); }));
  add(HS_PART_STRAIN, model.blocks.has_deformable());
  add(HS_PART_LOCAL_DAMPING, model.settings.local_damping > 0);
  add(HS_PART_MASS_DAMPING, model.settings.mass_damping > 0);
  add(HS_PART_SLEEP, model.settings.sleep_tolerance > 0);
  add(HS_PART_WATER, !model.water.empty());
  add(HS_PART_BOLTS, !model.bolts.empty());
  return parts;
}

template <int D>
void count_kinds(const Blocks<D>& blocks, hs_world_plan& plan) {
  std::int64_t of_meshes = 0;  // counted as cells
  std::int64_t* const counts[] = {&plan.fixed_count, &plan.prescribed_count, &plan.rigid_count,
                                  &plan.affine_count, &of_meshes};
  for_each_block(blocks, [&](std::int64_t, std::int32_t slot) {
    ++*counts[std::int32_t(blocks.kind[std::size_t(slot)])];
  });
}

template <int D>
void count_meshes_and_bonds(const Blocks<D>& blocks, hs_world_plan& plan) {
  for (const Body<D>& body : blocks.meshes().bodies()) {
    if (body.node_count == 0) continue;  // a body that has been removed
    ++plan.body_count;
    plan.node_count += body.node_count;
  }
  blocks.meshes().for_each_element([&](const auto&) { ++plan.cell_count; });
  plan.mesh_bytes = std::int64_t(snapshot::state_size(blocks.meshes()));
  plan.bond_count = std::int64_t(blocks.bonds().all().size());
  plan.bond_bytes = std::int64_t(snapshot::state_size(blocks.bonds()));
}

template <int D>
void find_limit(World<D>& world, hs_world_plan& plan) {
  plan.limiting_bond = plan.limiting_cell = -1;
  const typename StableStep<D>::Limit limit = world.state().stable_step.limit();
  if (limit.block < 0) return;
  plan.stable_time_step = limit.step;
  plan.limiting_block = id_of(world.blocks(), std::size_t(limit.block));
  if (const auto neighbor = world.state().stable_step.stiffest_neighbor_of(limit.block)) {
    plan.limiting_neighbor = id_of(world.blocks(), std::size_t(neighbor->block));
    plan.limiting_bond = neighbor->bond;
  }
  if (!limit.by_itself || !world.blocks().is_of_mesh(std::size_t(limit.block))) return;
  const Meshes<D>& meshes = world.blocks().meshes();
  const std::int32_t body = meshes.surface_of_block(std::size_t(limit.block)).body;
  plan.limiting_body = id_of(meshes, body);
  plan.limiting_cell = meshes.stiffest_cell_of(body, world.model().materials.bulk());
}

template <int D>
void measure(World<D>& world, std::int64_t steps, hs_world_plan& plan) {
  Stopwatch stopwatch;
  world.stages().set_stopwatch(&stopwatch);
  while (plan.measured_steps < steps && world.step() == StepResult::ok) ++plan.measured_steps;
  world.stages().set_stopwatch(nullptr);
  if (plan.measured_steps == 0) return;
  const auto a_step = [&](Pass pass) { return stopwatch.seconds(pass) / double(plan.measured_steps); };
  plan.search_seconds = a_step(Pass::search);
  plan.pair_seconds = a_step(Pass::pairs);
  plan.gather_seconds = a_step(Pass::gather);
  plan.bond_seconds = a_step(Pass::bonds);
  plan.hard_contact_seconds = a_step(Pass::hard_contacts);
  plan.motion_seconds = a_step(Pass::motion);
  plan.ledger_seconds = a_step(Pass::book);
  plan.water_seconds = a_step(Pass::water);
  plan.bolt_seconds = a_step(Pass::bolts);
}

}  // namespace

hs_status hs_world_get_plan(const hs_world* world, int64_t steps, hs_world_plan* plan, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& given) {
    require_count(steps, "steps");
    require_pointer(plan, "plan");
    require_report_size(size, sizeof(hs_world_plan));
    PreparedCopy<D> copy(*world, given);
    World<D>& w = copy.world;
    hs_world_plan ours{};
    ours.dimension = D;
    count_kinds(w.blocks(), ours);
    count_meshes_and_bonds(w.blocks(), ours);
    ours.parts = active_parts(w);
    ours.bolt_count = std::int64_t(w.model().bolts.all().size());
    ours.candidate_count = std::int64_t(w.state().contacts.neighbors().pairs().size());
    ours.contact_count = std::int64_t(w.state().contacts.count());
    ours.block_bytes = std::int64_t(snapshot::state_size(w.blocks()));
    ours.pair_bytes = std::int64_t(snapshot::state_size(w.state().contacts));
    find_limit(w, ours);
    measure(w, steps, ours);
    write_sized(ours, plan, size);
    return HS_OK;
  });
}
