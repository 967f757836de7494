#include "plan.h"

#include <map>
#include <set>
#include <utility>

#include "jointed_rock.h"
#include "keys.h"
#include "text.h"
#include "triangulation.h"

namespace halfspace::cli {
namespace {

const char* describe(int fault) {
  switch (fault) {
    case HS_FAULT_TOO_FEW_VERTICES:
      return "fewer than 3 vertices";
    case HS_FAULT_NOT_FINITE:
      return "a coordinate too large or too small to compute with";
    case HS_FAULT_REPEATED_VERTEX:
      return "the same place as its neighbour";
    case HS_FAULT_COLLINEAR_VERTEX:
      return "on the line of its neighbours";
    case HS_FAULT_NOT_CONVEX:
      return "a corner that turns inwards";
    case HS_FAULT_SELF_CROSSING:
      return "the outline crosses itself or winds more than once";
    case HS_FAULT_ZERO_AREA:
      return "all vertices on one line";
    default:
      return "not a polygon";
  }
}

/// A convex outline can be given as a block or as a region; what is wrong with it is told at its place in the
/// file.
bool is_convex(const Context& context, const std::vector<Point>& vertices, Place place,
               const std::string& key, Faults& faults) {
  hs_fault fault{};
  require(context, hs_polygon_check(context.get(), view_of(vertices), &fault));
  if (fault.kind == HS_FAULT_NONE) return true;
  std::string text;
  if (fault.vertex >= 0) {
    const Point vertex = vertices[static_cast<std::size_t>(fault.vertex)];
    text = "vertex " + std::to_string(fault.vertex) + " [" + shortest(vertex[0]) + ", " +
           shortest(vertex[1]) + "]: ";
  }
  faults.add(place, key, text + describe(fault.kind) + "; allowed: the corners of a convex polygon in order");
  return false;
}

/// Adds blocks one by one. Once there is a fault the plan will not be used, and only what can still be wrong
/// is checked.
class Planner {
 public:
  Planner(const Context& context, Faults& faults) : context_(context), faults_(faults) {}

  void add(const Block& block) {
    const Making& making = block.making;
    claim(making);
    if (block.vertices.empty() ||  // a fault already
        !is_convex(context_, block.vertices, block.vertices_place, making.key + ".vertices", faults_)) {
      misshapen_.insert(making.name);
      return;
    }
    add(making.name, making, make_polygon(context_, block.vertices), block.motion);
  }

  void add(const JointedRock& rock) {
    const Making& making = rock.making;
    claim(making);
    if (!rock.region.empty())
      is_convex(context_, rock.region, rock.region_place, making.key + ".region", faults_);
    if (!may_generate(making)) return;
    JointedBlocks cut = cut_jointed_rock(context_, rock);
    for (std::size_t i = 0; i < cut.blocks.size(); ++i) add_member(making, i, std::move(cut.blocks[i]));
    plan_.left_out += cut.left_out;
    plan_.area_left_out += cut.area_left_out;
  }

  void add(const Triangulated& region) {
    claim(region.making);
    if (!may_generate(region.making)) return;
    const std::vector<Triangle> triangles = triangulate(region);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      add_member(region.making, i, make_polygon(context_, {triangles[i].begin(), triangles[i].end()}));
    }
  }

  void track(const std::string& name, Place place) {
    const auto found = index_of_.find(name);
    if (found != index_of_.end()) {
      plan_.tracked.push_back(found->second);
      return;
    }
    if (misshapen_.contains(name)) return;
    for (const std::string& generator : not_generated_) {
      if (name.starts_with(generator + '.')) return;
    }
    std::vector<std::string_view> names;
    for (const auto& [known, index] : index_of_) names.push_back(known);
    faults_.add(place, "output.tracked",
                "no such block: \"" + name + '"' + suggestion(name, names) +
                    "; allowed: the name of a [[block]], or NAME.0, NAME.1, ... of a generator");
  }

  Plan take() { return std::move(plan_); }

 private:
  /// Generators need whole settings.
  bool may_generate(const Making& making) {
    if (faults_.none()) return true;
    not_generated_.push_back(making.name);
    return false;
  }

  /// Blocks and generators share one set of names.
  void claim(const Making& making) {
    if (!making.name.empty() && !claimed_.insert(making.name).second) told_twice(making, making.name);
  }

  void add(const std::string& name, const Making& making, Shape shape, const Motion& motion) {
    if (!index_of_.emplace(name, plan_.blocks.size()).second) told_twice(making, name);
    plan_.blocks.push_back({name, making.material, making.kind, std::move(shape), motion});
  }

  void add_member(const Making& making, std::size_t index, Shape shape) {
    add(making.name + '.' + std::to_string(index), making, std::move(shape), {});
  }

  void told_twice(const Making& making, const std::string& name) {
    faults_.add(making.place, making.key + ".name", "used twice: \"" + name + "\"; allowed: a new name");
  }

  const Context& context_;
  Faults& faults_;
  Plan plan_;
  std::map<std::string, std::size_t> index_of_;
  std::set<std::string> claimed_;
  std::set<std::string> misshapen_;
  std::vector<std::string> not_generated_;
};

}  // namespace

Plan plan_blocks(const Context& context, const Scene& scene, Faults& faults) {
  Planner planner(context, faults);
  for (const Block& block : scene.blocks) planner.add(block);
  for (const JointedRock& rock : scene.jointed_rocks) planner.add(rock);
  for (const Triangulated& region : scene.triangulated) planner.add(region);
  for (std::size_t i = 0; i < scene.output.tracked.size(); ++i) {
    planner.track(scene.output.tracked[i], scene.output.tracked_places[i]);
  }
  return planner.take();
}

}  // namespace halfspace::cli
