#include <algorithm>
#include <limits>
#include <string>

#include "common/text.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

void note_time_step(const Start& start, Faults& faults) {
  constexpr double smallest_fraction = 1e-4;
  const double given = start.scene.world.time_step, stable = start.model.report().stable_time_step;
  if (!(stable > 0 && given > 0)) return;
  const std::string step = shortest(given) + " s is ";
  if (given > stable) {
    faults.note(start.scene.places.time_step, "world.time_step",
                step + "above the stable time step, " + rounded(stable, 4) + " s");
  } else if (given < smallest_fraction * stable) {
    faults.note(
        start.scene.places.time_step, "world.time_step",
        step + "far below the stable time step, " + rounded(stable, 4) + " s; usual: 0.1 to 1 times that");
  }
}

void note_duration(const Start& start, Faults& faults) {
  constexpr double min_steps = 2, max_steps = 1e9;
  const Scene& scene = start.scene;
  const hs_world_report& report = start.model.report();
  const double step =
      scene.world.time_step > 0 ? scene.world.time_step : scene.world.safety * report.stable_time_step;
  if (!(step > 0) || !scene.stages.empty()) return;
  const double steps = scene.duration / step;
  if (steps > max_steps) {
    faults.note(scene.places.duration, "world.duration",
                shortest(scene.duration) + " s takes " + rounded(steps, 2) + " steps of " + rounded(step, 3) +
                    " s; usual: up to 1e8 steps");
  } else if (steps < min_steps && step <= report.stable_time_step) {
    faults.note(scene.places.duration, "world.duration",
                shortest(scene.duration) + " s is shorter than " + rounded(min_steps, 1) + " steps of " +
                    rounded(step, 3) + " s; usual: hundreds of steps");
  }
}

void note_output(const Start& start, Faults& faults) {
  constexpr double max_frames = 1e5, max_rows = 1e7;
  const Scene& scene = start.scene;
  const auto note = [&](Place place, const char* key, double interval, double max_count) {
    if (!(scene.duration > 0)) return;
    const std::string text = shortest(interval) + " s is ";
    if (interval > scene.duration) {
      faults.note(place, key, text + "longer than the run, " + shortest(scene.duration) + " s");
    } else if (scene.duration / interval > max_count) {
      faults.note(place, key,
                  text + "short for " + shortest(scene.duration) +
                      " s: " + rounded(scene.duration / interval, 2) + " of them; usual: up to " +
                      shortest(max_count));
    }
  };
  note(scene.places.frame_interval, "output.frame_interval", scene.output.frame_interval, max_frames);
  if (scene.output.history_interval != scene.output.frame_interval)
    note(scene.places.history_interval, "output.history_interval", scene.output.history_interval, max_rows);
}

/// Without damping no block comes to rest.
void note_rest(const Start& start, Faults& faults) {
  const Scene& scene = start.scene;
  const bool damps =
      scene.world.local_damping > 0 || scene.world.mass_damping > 0 ||
      any_law(scene, [](const hs_law_def& law) { return law.normal_damping > 0 || !has_spring(law); });
  if (scene.rest_speed > 0 && !damps)
    faults.note(scene.places.rest_speed, "world.rest_speed",
                shortest(scene.rest_speed) +
                    " m/s may never be reached without damping; usual: a normal_damping or local_damping");
}

void note_motions(const Start& start, Faults& faults) {
  if (!(start.scene.duration > 0)) return;
  for (const Block& block : start.scene.blocks) {
    if (block.motion.start < start.scene.duration) continue;
    faults.note(block.making.place, block.making.key,
                quoted(block.making.name) + " starts to move at " + shortest(block.motion.start) +
                    " s, after the end of the run, " + shortest(start.scene.duration) + " s");
  }
}

/// The time from the begin of a stage to the end of the run; infinite with stages that settle.
double time_after(const Scene& scene, std::size_t stage) {
  if (scene.stages.empty()) return scene.duration;
  double time = 0;
  for (std::size_t i = stage; i < scene.stages.size(); ++i)
    time += scene.stages[i].settles ? std::numeric_limits<double>::infinity() : scene.stages[i].duration;
  return time;
}

/// A table that goes on after the run may have times in another unit.
void note_table(const Scene& scene, const TimeTable& table, std::size_t stage, Faults& faults) {
  constexpr double rounding = 1e-9;
  const double end = time_after(scene, stage);
  if (table.times.empty() || !(table.times.back() > end * (1 + rounding))) return;
  faults.note(table.place, table.key,
              "its last row is at " + shortest(table.times.back()) + " s, and the run ends at " +
                  rounded(end, 4) + " s; usual: times in s, up to the end of the run");
}

void note_tables(const Start& start, Faults& faults) {
  const Scene& scene = start.scene;
  for (const Action& action : scene.actions) note_table(scene, action.table, action.stage, faults);
  for (const Mesh& mesh : scene.meshes) {
    for (const MeshSupport& support : mesh.supports) note_table(scene, support.table, support.stage, faults);
    for (const MeshLoad& load : mesh.loads) note_table(scene, load.table, load.stage, faults);
  }
}

}  // namespace

void note_times(const Start& start, Faults& faults) {
  note_time_step(start, faults);
  note_duration(start, faults);
  note_output(start, faults);
  note_rest(start, faults);
  note_motions(start, faults);
  note_tables(start, faults);
}

}  // namespace halfspace::cli
