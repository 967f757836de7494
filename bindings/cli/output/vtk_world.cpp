#include "output/vtk_world.h"

#include <map>
#include <numeric>

namespace halfspace::cli {
namespace {

std::vector<Point> vertices_in(const Context& context, const hs_world* world, hs_block block) {
  std::vector<Point> vertices(8);
  int64_t count = 0;
  require(context, hs_world_get_block_vertices(world, block, view_of(vertices), &count));
  const bool are_all = count <= static_cast<int64_t>(vertices.size());
  vertices.resize(static_cast<std::size_t>(count));
  if (!are_all) require(context, hs_world_get_block_vertices(world, block, view_of(vertices), nullptr));
  return vertices;
}

/// The faces of a block; in space those of its hull, whose vertices have another order.
std::vector<std::vector<int>> faces_by(const Context& context, int dimension, std::vector<Point>& vertices) {
  if (dimension == 3) {
    const Shape hull = make_hull(context, vertices);
    vertices = vertices_of(context, hull);
    return faces_of(context, hull);
  }
  std::vector<int> outline(vertices.size());
  std::iota(outline.begin(), outline.end(), 0);
  return {outline};
}

/// The stresses and strains of the cells of all bodies.
class CellStates {
 public:
  CellStates(const Context& context, const hs_world* world) : context_(context), world_(world) {}

  void write(hs_block block, hs_deformation& deformation) {
    hs_body body = 0;
    int32_t cell = 0;
    require(context_, hs_world_get_body_of_block(world_, block, &body, &cell));
    const hs_cell_state& state = cells_of(body).at(static_cast<std::size_t>(cell));
    std::copy(std::begin(state.stress), std::end(state.stress), deformation.stress);
    std::copy(std::begin(state.strain), std::end(state.strain), deformation.strain);
  }

 private:
  const std::vector<hs_cell_state>& cells_of(hs_body body) {
    std::vector<hs_cell_state>& cells = of_bodies_[body];
    if (cells.empty()) {
      int64_t count = 0;
      require(context_, hs_world_get_cells(world_, body, nullptr, 0, &count));
      cells.resize(static_cast<std::size_t>(count));
      require(context_, hs_world_get_cells(world_, body, cells.data(), count, nullptr));
    }
    return cells;
  }

  const Context& context_;
  const hs_world* world_;
  std::map<hs_body, std::vector<hs_cell_state>> of_bodies_;
};

}  // namespace

WorldPicture picture_of(const Context& context, const hs_world* world, const hs_pose* start) {
  hs_world_report report;
  require(context, hs_world_get_report(const_cast<hs_world*>(world), &report, sizeof report));
  const std::vector<hs_block> blocks = all_records(context, world, hs_world_get_blocks);
  WorldPicture picture;
  picture.layout.dimension = report.dimension;
  picture.frame.time = report.time;
  std::map<hs_block, std::size_t> index_of;
  CellStates bodies(context, world);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    index_of.emplace(blocks[i], i);
    LayoutBlock block;
    BlockFrame frame;
    require(context, hs_world_get_block_state(world, blocks[i], &frame.state));
    block.kind = frame.state.kind;
    frame.vertices = vertices_in(context, world, blocks[i]);
    if (!frame.vertices.empty()) block.faces = faces_by(context, report.dimension, frame.vertices);
    if (block.kind == HS_BLOCK_AFFINE)
      require(context, hs_world_get_deformation(world, blocks[i], &frame.deformation));
    if (block.kind == HS_BLOCK_MESH) bodies.write(blocks[i], frame.deformation);
    picture.start.blocks.push_back({.state = frame.state, .deformation = {}, .vertices = {}});
    if (start) picture.start.blocks.back().state.pose = start[i];
    picture.layout.blocks.push_back(std::move(block));
    picture.frame.blocks.push_back(std::move(frame));
  }
  picture.frame.contacts = all_records(context, world, hs_world_get_contacts);
  for (hs_contact& contact : picture.frame.contacts) {
    contact.block_a = index_of.at(contact.block_a);
    contact.block_b = index_of.at(contact.block_b);
  }
  return picture;
}

}  // namespace halfspace::cli
