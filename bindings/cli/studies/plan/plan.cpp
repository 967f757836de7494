#include "studies/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"
#include "studies/plan/without.h"
#include "studies/trade/measure.h"
#include "studies/trade/pieces.h"
#include "studies/trade/quantity.h"

namespace halfspace::cli {
namespace {

constexpr std::int64_t measured_steps = 200;
constexpr double short_run_of_plan = 0.05;  // s of CPU time; shorter runs are repeated, as clocks are coarse

std::string plan_line(const std::string& name, const std::string& value) {
  return report_line(name, value, 21);
}

std::string percent(double fraction) {
  return (std::abs(fraction) < 0.01 ? rounded(100 * fraction, 1) : decimals(100 * fraction, 0)) + " %";
}

/// The end of a run.
struct End {
  RunEnd end = RunEnd::whole;
  double cpu_seconds = 0;
  Frame frame;
  std::vector<Piece> pieces;
  hs_world_plan world{};
  std::string limit;         ///< the block that limits the step, and its neighbour
  std::string made_of_many;  ///< concave blocks and terrains, as lines of the report
};

std::string name_of(const Model& model, hs_block block) {
  return model.layout().blocks[model.index_of(block)].name;
}

/// The block and its neighbour, or the element, that limits the time step.
std::string limit_of(const Model& model, const hs_world_plan& world) {
  if (world.limiting_body != 0) {
    const std::size_t cell = model.index_of(world.limiting_body, static_cast<int32_t>(world.limiting_cell));
    return model.layout().blocks[cell].name + " as an element";
  }
  const std::string block = name_of(model, world.limiting_block);
  if (world.limiting_neighbor == 0) return block;
  return block + (world.limiting_bond < 0 ? ", at " : ", bonded to ") +
         name_of(model, world.limiting_neighbor);
}

/// Concave blocks with their parts, and terrains with the blocks behind them.
std::string lines_of_many(const Layout& layout) {
  std::string text;
  std::size_t parts = 0, of_terrain = 0;
  for (const LayoutCompound& compound : layout.compounds) parts += compound.part_count;
  for (const LayoutBlock& block : layout.blocks) of_terrain += block.key.starts_with("terrain");
  if (parts > 0) {
    text += plan_line("concave blocks", std::to_string(layout.compounds.size()) + " of " +
                                            std::to_string(parts) + " convex parts");
  }
  if (of_terrain > 0) text += plan_line("terrain", std::to_string(of_terrain) + " of the blocks");
  return text;
}

/// A disturbance of 0 is none.
End run(const Scene& scene, int disturbance = 0) {
  const Context context = make_context(scene.threads);
  Layout layout = layout_of(context, scene);
  disturb(context, disturbance, layout);
  Model model(context, scene, std::move(layout));
  const Outcomes outcomes = run_for_quantity(scene, model);
  End end{outcomes.end,
          outcomes.cpu_seconds,
          frame_at(model, outcomes.time),
          pieces_of(model.layout()),
          model.account(measured_steps),
          {},
          lines_of_many(model.layout())};
  if (end.world.limiting_block != 0) end.limit = limit_of(model, end.world);
  return end;
}

End run_repeatedly(const Scene& scene) {
  return fastest_of(short_run_of_plan, [&] { return run(scene); });
}

/// The largest displacement error of a free piece, over its size.
double difference(const End& whole, const End& other) {
  double largest = 0;
  for (std::size_t i = 0; i < whole.pieces.size(); ++i) {
    const Piece& piece = whole.pieces[i];
    if (!is_free(piece, whole.frame)) continue;
    largest = std::max(
        largest, distance(piece, whole.frame, other.pieces[i], other.frame) / size_of(piece, whole.frame));
  }
  return largest;
}

std::string kinds(const hs_world_plan& world) {
  std::string text;
  for (const auto& [count, name] :
       {std::pair{world.fixed_count, "fixed"}, std::pair{world.prescribed_count, "prescribed"},
        std::pair{world.rigid_count, "rigid"}, std::pair{world.affine_count, "affine"}}) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + name;
  }
  return text.empty() ? "none" : text;
}

std::string meshes(const hs_world_plan& world) {
  return std::to_string(world.body_count) + (world.body_count == 1 ? " body" : " bodies") + " of " +
         std::to_string(world.cell_count) + " cells and " + std::to_string(world.node_count) + " nodes";
}

/// Bytes per cell include those of the blocks at the surface.
std::string memory(const hs_world_plan& world) {
  std::string text;
  const auto add = [&](std::int64_t bytes, std::int64_t count, const char* name) {
    if (count == 0) return;
    const double each = static_cast<double>(bytes) / static_cast<double>(count);
    text += (text.empty() ? "" : ", ") + decimals(each, 0) + " B per " + name;
  };
  const std::int64_t blocks =
      world.fixed_count + world.prescribed_count + world.rigid_count + world.affine_count;
  const std::int64_t without_bonds = world.block_bytes - world.bond_bytes;
  world.cell_count > 0 ? add(without_bonds, world.cell_count, "cell") : add(without_bonds, blocks, "block");
  add(world.bond_bytes, world.bond_count, "bond");
  add(world.pair_bytes, world.candidate_count, "pair");
  return text;
}

std::string pass_times(const hs_world_plan& world) {
  const std::pair<double, const char*> passes[] = {{world.pair_seconds, "pairs"},
                                                   {world.gather_seconds, "forces gathered"},
                                                   {world.bond_seconds, "bonds"},
                                                   {world.water_seconds, "water"},
                                                   {world.bolt_seconds, "bolts"},
                                                   {world.motion_seconds, "motion"},
                                                   {world.hard_contact_seconds, "springless contacts"},
                                                   {world.ledger_seconds, "ledger"},
                                                   {world.search_seconds, "search for neighbours"}};
  double all = 0;
  for (const auto& [seconds, name] : passes) all += seconds;
  if (all == 0) return "not measured";
  std::string text = rounded(1e6 * all, 3) + " us: ";
  bool is_first = true;
  for (const auto& [seconds, name] : passes) {
    if (seconds == 0) continue;
    text += (is_first ? "" : ", ") + percent(seconds / all) + ' ' + name;
    is_first = false;
  }
  return text;
}

std::string parts(const Scene& scene, int active, bool are_active) {
  std::string text;
  for (const PartName& named : part_names())
    if (((active & named.part) != 0) == are_active)
      text += (text.empty() ? "" : ", ") + std::string(named.name);
  if (are_active && !scene.actions.empty()) text += text.empty() ? "actions" : ", actions";
  return text.empty() ? "nothing" : text;
}

std::string account(const Scene& scene, const End& whole) {
  const hs_world_plan& world = whole.world;
  std::string text = plan_line("scene", scene.title.empty() ? "untitled" : scene.title) +
                     (scene.settings.empty() ? std::string() : plan_line("set", scene.settings)) +
                     plan_line("blocks", kinds(world));
  if (world.body_count > 0) text += plan_line("meshes", meshes(world));
  text += whole.made_of_many;
  text += plan_line("pairs", std::to_string(world.candidate_count) + " near each other, " +
                                 std::to_string(world.contact_count) + " in contact");
  if (world.bond_count > 0) text += plan_line("bonds", std::to_string(world.bond_count));
  if (world.bolt_count > 0) text += plan_line("bolts", std::to_string(world.bolt_count));
  if (!scene.actions.empty()) text += plan_line("actions", std::to_string(scene.actions.size()));
  text += plan_line("memory", memory(world));
  text += plan_line("per step", pass_times(world));
  if (world.stable_time_step > 0)
    text += plan_line("stable step", rounded(world.stable_time_step, 3) + " s, limited by " + whole.limit);
  text += plan_line("active", parts(scene, world.parts, true));
  return text + plan_line("inactive", parts(scene, world.parts, false));
}

std::string judged(const End& whole, const End& other, double tolerance) {
  if (other.end != RunEnd::whole) return "does not run to the end";
  const double off = difference(whole, other);
  const double saved = 1 - other.cpu_seconds / whole.cpu_seconds;
  const std::string text = padded(percent(saved), 10) + percent(off) + " of its size";
  return off <= tolerance ? padded(text, 32) + "can be left out, within " + percent(tolerance) : text;
}

}  // namespace

PlanResult plan(const Scene& given, const PlanOptions& options) {
  remember_interrupts();
  Scene scene = given;
  scene.reference = {};
  scene.reference.time = options.time > 0 ? options.time : scene.duration;
  PlanResult result;
  const End whole = run_repeatedly(scene);
  result.end = whole.end;
  result.report = account(scene, whole);
  if (result.end != RunEnd::whole) return result;
  const std::vector<Without> all =
      without_each(scene, whole.world.parts, typical_face(scene), names_cells(scene));
  const End disturbed = run(scene, 1);
  if (disturbed.end == RunEnd::interrupted) {
    result.end = disturbed.end;
    return result;
  }
  const double chance = disturbed.end == RunEnd::whole ? difference(whole, disturbed) : HUGE_VAL;
  const bool is_predictable = chance <= options.tolerance;
  result.report += '\n' + plan_line("without", padded("saves", 10) + "max displacement error of a block");
  for (const Without& one : all) {
    const End other = run_repeatedly(one.scene);
    if (other.end == RunEnd::interrupted) {
      result.end = other.end;
      return result;
    }
    result.report += plan_line(one.part, judged(whole, other, is_predictable ? options.tolerance : 0));
  }
  result.report += plan_line(
      "moved by 1e-9", padded("", 10) + (std::isfinite(chance) ? percent(chance) + " of its size, by chance"
                                                               : std::string("does not run to the end")));
  if (!is_predictable)
    result.report +=
        "\nChance displaces blocks by more than " + percent(options.tolerance) +
        " of their size: give a shorter --time, or use\n`halfspace trade`, whose quantities of the whole "
        "scene depend less on chance.\n";
  return result;
}

}  // namespace halfspace::cli
