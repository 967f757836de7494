#include "model/layout.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "blocks/elements/block_mesh.h"
#include "blocks/elements/lay_out_mesh.h"
#include "blocks/rock/jointed_rock.h"
#include "blocks/rock/triangulation.h"
#include "blocks/rock/voronoi.h"
#include "blocks/terrain/terrain_blocks.h"
#include "common/suggestion.h"
#include "common/text.h"
#include "model/bolt_ends.h"
#include "model/checked_shape.h"
#include "model/followers.h"
#include "model/joint_stress.h"
#include "model/near_blocks.h"

namespace halfspace::cli {
namespace {

/// Builds a layout block by block. After a fault the layout is not used, and blocks are only checked.
class LayoutBuilder {
 public:
  LayoutBuilder(const Context& context, const Scene& scene, Faults& faults)
      : context_(context),
        faults_(faults),
        shapes_(context, scene.world.dimension, faults),
        given_axes_(scene.world.dimension) {
    layout_.dimension = scene.world.dimension;
    has_all_names_ = scene.has_all_names;
    for_each_making(scene,
                    [&](const Making& making) { has_all_names_ = has_all_names_ && !making.name.empty(); });
    is_excavated_ = std::any_of(scene.stages.begin(), scene.stages.end(),
                                [](const SceneStage& stage) { return !stage.excavated.empty(); });
  }

  void add(const Block& block) {
    const Making& making = block.making;
    claim(making);
    std::vector<Shape> shapes = shapes_.of(block);
    if (shapes.empty()) without_blocks_.push_back(making.name);
    if (shapes.size() == 1) {
      add(making.name, making, std::move(shapes[0]), block.placing, block.motion);
      return;
    }
    const bool is_compound = block.is_joined || !block.vertices.empty();
    if (is_compound && !shapes.empty()) layout_.compounds.push_back({layout_.blocks.size(), shapes.size()});
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      add(member(making, i), making, std::move(shapes[i]), block.placing, block.motion);
      if (is_compound) layout_.blocks.back().compound = layout_.compounds.size() - 1;
    }
  }

  void add(const JointedRock& rock) {
    claim(rock.making);
    std::vector<Shape> regions;
    for (const Region& region : rock.regions) regions.push_back(shapes_.of(region));
    if (!may_generate(rock.making)) return;
    generate(rock.making, [&] { cut(rock, std::move(regions)); });
  }

  void add(const Voronoi& voronoi) {
    claim(voronoi.making);
    const Shape region = shapes_.of(voronoi.region);
    if (!may_generate(voronoi.making)) return;
    generate(voronoi.making, [&] { add_members(voronoi.making, voronoi_blocks(context_, voronoi, region)); });
  }

  void add(const Triangulated& region) {
    claim(region.making);
    if (!may_generate(region.making)) return;
    generate(region.making, [&] {
      std::vector<Shape> shapes;
      for (const Triangle& triangle : triangulate(region))
        shapes.push_back(make_polygon(context_, {triangle.begin(), triangle.end()}));
      add_members(region.making, std::move(shapes));
    });
  }

  void add(const Mesh& mesh) {
    claim(mesh.making);
    if (!may_generate(mesh.making)) return;
    LaidOutMesh laid_out = lay_out_mesh(context_, mesh, layout_.dimension, is_excavated_, faults_);
    if (laid_out.bodies.empty()) without_blocks_.push_back(mesh.making.name);
    add(std::move(laid_out), mesh.making.name, mesh.making, mesh.placing, mesh.velocity);
  }

  void add(const Terrain& terrain) {
    claim(terrain.making);
    if (!may_generate(terrain.making)) return;
    generate(terrain.making, [&] {
      try {
        std::size_t count = 0;
        make_terrain_blocks(context_, read_surface(terrain), terrain.depth, [&](TerrainBlock block) {
          add_block(member(terrain.making, count++), terrain.making, std::move(block.shape),
                    {.rotation = {}, .shift = block.place}, {});
          layout_.blocks.back().faces = {std::move(block.top)};
          ++layout_.terrain_count;
        });
      } catch (const LibraryError&) {
        throw;
      } catch (const std::runtime_error& error) {
        faults_.add(terrain.shape_place, terrain.making.key + ".file", error.what());
        without_blocks_.push_back(terrain.making.name);
      }
    });
  }

  /// Adds the blocks that a stage excavates.
  void excavate(const SceneStage& stage, std::size_t number) {
    std::vector<std::size_t>& blocks = layout_.excavated.emplace_back();
    for (const std::string& name : stage.excavated) {
      const auto group = groups_.find(name);
      const auto block = index_of_.find(name);
      if (group != groups_.end()) {
        blocks.insert(blocks.end(), group->second.begin(), group->second.end());
      } else if (block != index_of_.end()) {
        name_block(block->second);
        blocks.push_back(block->second);
      } else if (members_.contains(name)) {
        blocks.insert(blocks.end(), members_[name].begin(), members_[name].end());
      } else if (!may_have_been(name)) {
        faults_.add(stage.excavated_place, "stage[" + std::to_string(number) + "].excavate",
                    "no such block: \"" + name +
                        "\"; allowed: the name of a block, of a generator or a mesh, or MESH/GROUP");
      }
    }
    take_whole_compounds(blocks);
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  }

  /// Adds the blocks of an action, which must be able to follow it.
  void act(const Action& action) {
    std::vector<std::size_t>& blocks = layout_.acted_on.emplace_back();
    if (action.on.empty()) {
      give_axes({}, action);
      return;
    }
    const auto made = members_.find(action.on);
    if (made != members_.end()) {
      blocks = made->second;
    } else if (const auto block = find(action.on, action.place, action.key.c_str())) {
      blocks = {*block};
    }
    if (action.table.times.empty()) return;  // a fault already: its components are unknown
    for (const std::size_t block : blocks) {
      if (can_follow(layout_.blocks[block], action, layout_.dimension)) continue;
      faults_.add(action.place, action.key,
                  "\"" + layout_.blocks[block].name + "\" cannot follow it; allowed: " + followers(action));
      return;
    }
    for (const std::size_t block : blocks) {
      if (!give_axes(block, action)) return;
    }
  }

  void track(const std::string& name, Place place) {
    if (const auto block = find(name, place, "output.tracked")) layout_.tracked.push_back(*block);
  }

  /// Tracks a point in the first block that contains it.
  void track(const TrackedPoint& point) {
    if (!faults_.none()) return;  // the blocks may be incomplete
    const auto nearest = nearest_block(context_, layout_, point.at);
    if (!nearest) return;
    if (nearest->distance > 0) {
      faults_.add(point.place, point.key,
                  described(point.at, layout_.dimension) + " is outside of all blocks; the nearest is \"" +
                      layout_.blocks[nearest->block].name + "\", " + rounded(nearest->distance, 3) +
                      " m away; allowed: a point of a block");
      return;
    }
    layout_.points.push_back({point.name, nearest->block, point.at});
  }

  void track(const TrackedJoint& joint) {
    if (!faults_.none()) return;
    const auto pair = joint.blocks.empty() ? blocks_at(joint) : blocks_named(joint);
    if (!pair) return;
    // The joint's plane is that of a block at rest, if there is one: sliding does not tilt it.
    const bool is_b_at_rest = !moves_freely(layout_.blocks[pair->second].kind);
    const auto [a, b] = is_b_at_rest ? std::pair(pair->second, pair->first) : *pair;
    const std::optional<PairPlane> plane = plane_between(context_, layout_.blocks[a], layout_.blocks[b]);
    if (plane) {
      layout_.joints.push_back({joint.name, a, b, plane->center, plane->normal, plane->gap});
    } else {
      faults_.add(joint.place, joint.key,
                  "no plane between these blocks; allowed: blocks that face each other");
    }
  }

  /// Sets the referenced blocks: a block, or all blocks of a generator or a mesh.
  void refer_to(const std::string& name, Place place) {
    const auto made = members_.find(name);
    if (made != members_.end()) {
      layout_.referenced = made->second;
    } else if (const auto block = find(name, place, "reference.block")) {
      layout_.referenced = {*block};
      name_block(*block);
    }
    const auto is_excavated = [&](std::size_t block) {
      return std::any_of(layout_.excavated.begin(), layout_.excavated.end(), [&](const auto& blocks) {
        return std::binary_search(blocks.begin(), blocks.end(), block);
      });
    };
    const std::vector<std::size_t>& blocks = layout_.referenced;
    if (!blocks.empty() && std::all_of(blocks.begin(), blocks.end(), is_excavated))
      faults_.add(place, "reference.block",
                  '"' + name + "\" is excavated; allowed: a block that stays to the end");
  }

  Layout take() { return std::move(layout_); }

 private:
  /// A part goes with all parts of its compound.
  void take_whole_compounds(std::vector<std::size_t>& blocks) const {
    for (std::size_t i = 0, count = blocks.size(); i < count; ++i) {
      const std::optional<std::size_t> compound = layout_.blocks[blocks[i]].compound;
      if (!compound) continue;
      const auto [first, parts] = layout_.compounds[*compound];
      for (std::size_t part = first; part < first + parts; ++part) blocks.push_back(part);
    }
  }

  void name_block(std::size_t block) { layout_.names_cells |= layout_.blocks[block].body.has_value(); }

  /// True if a reported fault may be the reason why there is no such block.
  bool may_have_been(const std::string& name) const {
    return !has_all_names_ ||
           std::any_of(without_blocks_.begin(), without_blocks_.end(), [&](const std::string& maker) {
             return name == maker || name.starts_with(maker + '.') || name.starts_with(maker + '/');
           });
  }

  /// The block that a key names.
  std::optional<std::size_t> find(const std::string& name, Place place, const char* key) {
    const auto found = index_of_.find(name);
    if (found != index_of_.end()) return found->second;
    if (may_have_been(name)) return std::nullopt;  // reported already
    std::vector<std::string_view> names;
    for (const auto& [known, index] : index_of_) names.push_back(known);
    faults_.add(
        place, key,
        "no such block: \"" + name + '"' + suggestion(name, names) +
            "; allowed: the name of a [[block]], or NAME.0, NAME.1, ... of a generator or a concave block");
    return std::nullopt;
  }

  std::optional<std::pair<std::size_t, std::size_t>> blocks_named(const TrackedJoint& joint) {
    const std::optional<std::size_t> a = find(joint.blocks[0], joint.place, joint.key.c_str());
    const std::optional<std::size_t> b = find(joint.blocks[1], joint.place, joint.key.c_str());
    if (!a || !b) return std::nullopt;
    if (can_touch(layout_, *a, *b)) return std::pair(*a, *b);
    faults_.add(joint.place, joint.key,
                '"' + joint.blocks[0] + "\" and \"" + joint.blocks[1] +
                    "\" never touch; allowed: two blocks of which one moves freely, not of one mesh or "
                    "concave block");
    return std::nullopt;
  }

  std::optional<std::pair<std::size_t, std::size_t>> blocks_at(const TrackedJoint& joint) {
    const auto pair = blocks_that_touch_at(context_, layout_, joint.at);
    if (!pair) {
      faults_.add(joint.place, joint.key,
                  "no two blocks that can touch each other; allowed: a point between two blocks");
    }
    return pair;
  }

  /// Generators run only without faults.
  bool may_generate(const Making& making) {
    if (faults_.none()) return true;
    without_blocks_.push_back(making.name);
    return false;
  }

  /// Blocks too small or too large to compute with are a fault of the generator.
  template <class Make>
  void generate(const Making& making, Make make) {
    try {
      make();
    } catch (const LibraryError& error) {
      faults_.add(making.place, making.key, error.what());
      without_blocks_.push_back(making.name);
    }
  }

  void cut(const JointedRock& rock, std::vector<Shape> regions) {
    try {
      JointedBlocks cut = cut_jointed_rock(context_, rock, std::move(regions));
      add_members(rock.making, std::move(cut.blocks));
      layout_.left_out += cut.left_out;
      layout_.size_left_out += cut.size_left_out;
      for (const JointSet* set : cut.idle_sets) {
        faults_.note(set->place, set->key,
                     "none of these joints, " + shortest(set->spacing) + " m apart, runs through the region");
      }
    } catch (const JointFault& fault) {
      faults_.add(fault.set.place, fault.set.key, fault.what());
      without_blocks_.push_back(rock.making.name);
    }
  }

  /// Blocks and generators share one set of names.
  void claim(const Making& making) {
    if (!making.name.empty() && !claimed_.insert(making.name).second) report_used_twice(making, making.name);
  }

  void add(const std::string& name, const Making& making, Shape shape, const Placing& placing,
           const Motion& motion) {
    if (making.kind == HS_BLOCK_MESH) {
      const ElementMesh cells = cells_of(making, shape);
      if (cells.cells.empty()) {
        faults_.add(making.place, making.key + ".cell_size",
                    "cuts " + name + " into more than 1000000 cells; allowed: a larger cell_size");
        return;
      }
      add(lay_out_block(context_, making, cells, placing, motion.velocity, is_excavated_, faults_), name,
          making, placing, motion.velocity);
    } else {
      add_block(name, making, std::move(shape), placing, motion);
    }
  }

  ElementMesh cells_of(const Making& making, const Shape& shape) const {
    const std::vector<Point> corners = vertices_of(context_, shape);
    return layout_.dimension == 2 ? mesh_of_polygon(corners, making.cell_size, making.cell_kind)
                                  : mesh_of_polyhedron(corners, faces_of(context_, shape), making.cell_size);
  }

  /// Adds the bodies of a mesh; their cells are blocks of the layout.
  void add(LaidOutMesh laid_out, const std::string& name, const Making& making, const Placing& placing,
           const Point& velocity) {
    for (LaidOutBody& body : laid_out.bodies) {
      body.body.first_block = layout_.blocks.size();
      for (LaidOutCell& cell : body.cells) {
        Making of_cell = making;
        of_cell.material = cell.material;
        add_block(name + '.' + std::to_string(cell.number), of_cell, std::move(cell.shape), placing,
                  {.velocity = velocity});
        layout_.blocks.back().faces = std::move(cell.faces);
        layout_.blocks.back().body = layout_.bodies.size();
        if (name != making.name) members_[name].push_back(layout_.blocks.size() - 1);
      }
      layout_.bodies.push_back(std::move(body.body));
    }
    for (const auto& [group, cells] : laid_out.groups) {
      std::vector<std::size_t>& blocks = groups_[name + '/' + group];
      for (const int cell : cells) blocks.push_back(index_of_.at(name + '.' + std::to_string(cell)));
    }
  }

  void add_block(const std::string& name, const Making& making, Shape shape, const Placing& placing,
                 const Motion& motion) {
    members_[making.name].push_back(layout_.blocks.size());
    if (!index_of_.emplace(name, layout_.blocks.size()).second) report_used_twice(making, name);
    std::vector<std::vector<int>> faces = outside_of(shape);
    layout_.blocks.push_back({name,
                              making.key,
                              making.place,
                              making.material,
                              making.kind,
                              making.stress,
                              std::move(shape),
                              std::move(faces),
                              placing,
                              motion,
                              {},
                              {}});
  }

  void add_members(const Making& making, std::vector<Shape> shapes) {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      add(member(making, i), making, std::move(shapes[i]), {}, {});
  }

  static std::string member(const Making& making, std::size_t index) {
    return making.name + '.' + std::to_string(index);
  }

  /// The faces of a shape, for output.
  std::vector<std::vector<int>> outside_of(const Shape& shape) const {
    if (layout_.dimension == 3) return faces_of(context_, shape);
    std::vector<int> outline(static_cast<std::size_t>(properties_of(context_, shape).vertex_count));
    std::iota(outline.begin(), outline.end(), 0);
    return {outline};
  }

  /// Reports each table once, even if many of its names are taken.
  void report_used_twice(const Making& making, const std::string& name) {
    if (!reported_.insert(making.key).second) return;
    faults_.add(making.place, making.key + ".name", "used twice: \"" + name + "\"; allowed: a new name");
  }

  const Context& context_;
  Faults& faults_;
  CheckedShapes shapes_;
  /// Reports a motion that is lost, because another action moves the block along the same axis. False if so.
  bool give_axes(std::optional<std::size_t> block, const Action& action) {
    if (block && layout_.blocks[*block].compound)
      block = layout_.compounds[*layout_.blocks[*block].compound].first_block;
    const auto fault = given_axes_.add(block, layout_.acted_on.size() - 1, action);
    if (!fault) return true;
    const std::string whose = block ? '"' + layout_.blocks[*block].name + "\" has " : "all blocks have ";
    faults_.add(action.place, action.key, whose + *fault);
    return false;
  }

  Layout layout_;
  GivenAxes given_axes_;
  bool is_excavated_;  ///< some of it in a stage
  std::map<std::string, std::size_t> index_of_;
  std::map<std::string, std::vector<std::size_t>> members_;  ///< blocks of generators, cells of meshes
  std::map<std::string, std::vector<std::size_t>> groups_;   ///< of meshes, with the blocks of their cells
  std::set<std::string> claimed_;
  std::set<std::string> reported_;           ///< keys of tables with names that are taken
  std::vector<std::string> without_blocks_;  ///< because of faults
  bool has_all_names_;
};

/// Reports the first generator that exceeds the max number of blocks, before any block is made.
void report_too_many_blocks(const Scene& scene, Faults& faults) {
  std::int64_t blocks = static_cast<std::int64_t>(scene.blocks.size());
  const auto add = [&](const Making& making, std::int64_t count) {
    const bool were_too_many = blocks > max_blocks;
    blocks += count;
    if (blocks <= max_blocks || were_too_many) return;
    faults.add(
        making.place, making.key + ".count",
        "makes " + std::to_string(blocks) + " blocks in all; allowed: at most " + std::to_string(max_blocks));
  };
  for (const Triangulated& region : scene.triangulated) add(region.making, region.count);
  for (const Voronoi& voronoi : scene.voronoi) add(voronoi.making, voronoi.count);
}

}  // namespace

bool Layout::has_deformable() const {
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const LayoutBlock& block) { return deforms(block.kind); });
}

Layout lay_out_blocks(const Context& context, const Scene& scene, Faults& faults) {
  report_too_many_blocks(scene, faults);
  LayoutBuilder builder(context, scene, faults);
  for (const Block& block : scene.blocks) builder.add(block);
  for (const JointedRock& rock : scene.jointed_rocks) builder.add(rock);
  for (const Triangulated& region : scene.triangulated) builder.add(region);
  for (const Voronoi& voronoi : scene.voronoi) builder.add(voronoi);
  for (const Mesh& mesh : scene.meshes) builder.add(mesh);
  for (const Terrain& terrain : scene.terrains) builder.add(terrain);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) builder.excavate(scene.stages[i], i);
  for (const Action& action : scene.actions) builder.act(action);
  for (std::size_t i = 0; i < scene.output.tracked.size(); ++i) {
    builder.track(scene.output.tracked[i], scene.output.tracked_places[i]);
  }
  for (const TrackedPoint& point : scene.output.tracked_points) builder.track(point);
  for (const TrackedJoint& joint : scene.output.tracked_joints) builder.track(joint);
  if (!scene.reference.block.empty()) builder.refer_to(scene.reference.block, scene.reference.block_place);
  Layout layout = builder.take();
  if (faults.none()) find_bolt_ends(context, scene, layout, faults);
  if (scene.in_situ && faults.none() && !layout.blocks.empty()) stress_joints(context, scene, layout, faults);
  return layout;
}

}  // namespace halfspace::cli
