// Scene files: whatever the text is, its faults are told, or it gives a model that starts, and whose frame
// the viewer shows.

#include "fuzz/bytes.h"
#include "fuzz/demand.h"
#include "model/layout.h"
#include "model/model.h"
#include "notes/notes.h"
#include "output/tables.h"
#include "output/vtk_file.h"
#include "output/vtk_series.h"
#include "recording/run_folder.h"
#include "scene/read_scene.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace::cli;
namespace viewer = halfspace::viewer;

constexpr double many = 300;  // blocks, for a target that is to be run a million times

double extent_of(const Region& region) {
  double extent = 0;
  for (const Point& p : region.points)
    for (const Point& q : region.points)
      for (int i = 0; i < 3; ++i) extent = std::max(extent, std::abs(p[std::size_t(i)] - q[std::size_t(i)]));
  return extent;
}

/// No more blocks than joints could make of regions that they run through one and all.
double max_blocks_of(const JointedRock& rock) {
  double sum = 0;
  for (const Region& region : rock.regions) {
    double blocks = 1;
    for (const JointSet& set : rock.joint_sets) blocks *= 2 + 2 * extent_of(region) / set.spacing;
    sum += blocks;
  }
  return sum;
}

/// Joints that are too many or lost in rounding are faults, which are found at once.
bool takes_long(const Scene& scene) {
  double blocks = double(scene.blocks.size());
  for (const JointedRock& rock : scene.jointed_rocks) {
    const double most = max_blocks_of(rock);
    if (most > many && most < 1e5 * double(max_blocks)) return true;
  }
  for (const Triangulated& region : scene.triangulated) blocks += double(region.count);
  for (const Voronoi& voronoi : scene.voronoi) blocks += double(voronoi.count * (1 + voronoi.relaxation));
  return blocks > many;
}

/// The viewer shows the blocks of a frame, with all of their vertices.
void view(const Scene& scene, const Layout& layout, const Frame& frame) {
  const std::size_t count = layout.terrain_begin();
  const viewer::RunFiles files = [&](const std::string& name) -> std::optional<std::string> {
    if (name == "run.pvd") return vtk_collection(vtk_entry(0, "frame"));
    if (name == "frame") return vtk_polygons(layout, frame, frame, {0, count});
    if (name == "blocks.csv") return blocks_table(scene, layout);
    return std::nullopt;
  };
  try {
    const viewer::Recording recording = viewer::read_run(files, "run");
    for (std::size_t b = 0; b < recording.block_count(); ++b)
      demand(recording.shape(b).vertices.size() == frame.blocks[b].vertices.size(),
             "a block is shown with all of its vertices");
  } catch (const std::invalid_argument& error) {
    demand(*error.what() != 0, "a place that no page can show is told");
  }
}

void start(const Context& context, const Scene& scene, Layout layout, Faults& faults) {
  try {
    Model model(context, scene, std::move(layout));
    note_start(context, scene, model, faults);
    model.step_towards(scene.duration, 3);
    const Frame frame = model.frame();
    demand(frame.blocks.size() == model.layout().blocks.size(), "a frame shows all blocks");
    view(scene, model.layout(), frame);
  } catch (const LibraryError& error) {
    demand(*error.what() != 0, "an error has a text");
  }
}

void run(const std::string& text) {
  const Context context = make_context();
  Faults faults;
  const Scene scene = read_scene_text(text, "scene.toml", faults);
  if (takes_long(scene)) return;
  Layout layout;
  try {
    layout = lay_out_blocks(context, scene, faults);
  } catch (const LibraryError& error) {
    demand(*error.what() != 0, "an error has a text");
    return;
  }
  demand(faults.none() == faults.describe("scene.toml").empty(), "faults are told");
  if (faults.none()) start(context, scene, std::move(layout), faults);
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::run(halfspace_fuzz::Bytes(data, size).rest());
  return 0;
}
