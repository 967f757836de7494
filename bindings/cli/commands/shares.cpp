#include "commands/shares.h"

#include <filesystem>
#include <stdexcept>

#include "model/model.h"
#include "shares/join.h"
#include "shares/shared_blocks.h"
#include "shares/split.h"

namespace halfspace::cli {
namespace {

std::string range(std::int64_t low, std::int64_t high) {
  return low == high ? std::to_string(low) : std::to_string(low) + " to " + std::to_string(high);
}

void split(const Context& context, hs_world* world, std::int64_t count, const Target& target) {
  OutputDirectory directory(target.directory, target.earlier);
  const SplitCounts counts = split(context, world, count, directory);
  print(stdout, target.directory + ": " + std::to_string(count) + " shares, each with " +
                    range(counts.min_own, counts.max_own) + " blocks and " +
                    range(counts.min_copies, counts.max_copies) + " copies\n");
}

/// Adds faults for what a run of the scene does between steps, and hosts of shares do not.
void require_steps_only(CheckedScene& checked) {
  Faults& faults = checked.faults;
  if (!checked.scene.stages.empty())
    faults.add({}, "stage", "shares do not run stages; allowed: a scene without them");
  if (!(checked.scene.world.time_step > 0))
    faults.add({}, "world.time_step", "shares require a time step, the same in all");
}

int split_scene(const SceneFile& file, std::int64_t count, const Target& target) {
  CheckedScene checked = load(file, 1);
  require_free_block(checked, "shares");
  if (checked.faults.none()) require_steps_only(checked);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  const Model model(checked.context, checked.scene, std::move(checked.layout));
  if (model.has_motion_changes())
    throw std::runtime_error(file.path +
                             ": shares do not start or stop motions; allowed: none with start or stop");
  split(checked.context, model.world(), count, target);
  return exit_ok;
}

}  // namespace

int split(const SceneFile& file, std::int64_t count, const Target& target) {
  if (!file.path.ends_with(".hsw")) return split_scene(file, count, target);
  if (!file.settings.empty())
    throw std::runtime_error("--set is for scenes; " + file.path + " is a snapshot");
  const Context context = make_context();
  const World world = restored(context, content_of(file.path));
  split(context, world.get(), count, target);
  return exit_ok;
}

int join(const std::string& directory, const std::string& file) {
  const Context context = make_context();
  const World whole = joined(context, directory);
  const std::filesystem::path target(file);
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  OutputDirectory(folder, Earlier::keep).write(target.filename().string(), snapshot_of(context, whole.get()));
  hs_world_report report{};
  require(context, hs_world_get_report(whole.get(), &report, sizeof report));
  print(stdout, file + ": " + std::to_string(report.block_count) + " blocks after " +
                    std::to_string(report.steps) + " steps\n");
  return exit_ok;
}

}  // namespace halfspace::cli
