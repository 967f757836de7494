#include <algorithm>
#include <stdexcept>

#include "model/model.h"

// The state of a model in checkpoints.

namespace halfspace::cli {
namespace {

void add_water_to(Archive& archive, std::optional<Water>& water) {
  bool is_there = water.has_value();
  archive.add(is_there);
  if (archive.reads()) water = is_there ? std::optional(Water()) : std::nullopt;
  if (!water) return;
  archive.add(water->def);
  archive.add(water->table);
  archive.require(!water->table.empty(), "its water table has no points");
}

/// Can a table be interpolated between two others?
bool has_waters_between(const std::optional<Water>& before, const std::optional<Water>& after) {
  if (!before || !after) return true;
  const std::size_t a = before->table.size(), b = after->table.size();
  return (a == b && before->def.columns == after->def.columns) || a == 1 || b == 1;
}

}  // namespace

std::string Model::snapshot() const { return snapshot_of(context_, world_.get()); }

void Model::add_to(Archive& archive) {
  std::string world = archive.reads() ? std::string() : snapshot();
  archive.add(world);
  archive.add(state_);
  archive.add(is_removed_);
  archive.add_each(released_, [&](std::vector<Point>& forces) { archive.add(forces); });
  add_water_to(archive, water_);
  add_water_to(archive, water_before_);
  archive.require(has_waters_between(water_before_, water_), "its water tables differ in their points");
  archive.add(bolt_numbers_);
  if (archive.reads()) restore(world);
}

void Model::restore(const std::string& world) {
  world_ = restored(context_, world);
  for (const auto& [body, index] : index_of_body_) bodies_[index] = is_excavated(index) ? 0 : body;
  if (!has_parts_of_layout()) throw std::runtime_error("its blocks, meshes or bonds differ");
  update_report();
  note_motions();
}

/// Checks that a restored world has all parts of the layout.
bool Model::has_parts_of_layout() const {
  const auto is_mark = [](char mark) { return mark >= 0 && mark <= 2; };
  if (is_removed_.size() != blocks_.size() || !std::all_of(is_removed_.begin(), is_removed_.end(), is_mark))
    return false;
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (!layout_.blocks[i].body && !is_removed_[i] && !has_block_of_layout(i)) return false;
  if (released_.size() != bodies_.size()) return false;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    if (!is_excavated(body) && !has_body_of_layout(body)) return false;
  const std::vector<hs_block> all = all_records(context_, world_.get(), hs_world_get_blocks);
  int64_t bonds = 0;
  (void)hs_world_get_bonds(world_.get(), nullptr, 0, &bonds);
  return static_cast<std::size_t>(bonds) == bonded_.size() && has_bolts_of_scene() &&
         std::all_of(all.begin(), all.end(), [&](hs_block block) { return is_of_layout(block); });
}

bool Model::has_block_of_layout(std::size_t block) const {
  const LayoutBlock& given = layout_.blocks[block];
  hs_block_state state{};
  int64_t vertices = 0;
  return hs_world_get_block_state(world_.get(), blocks_[block], &state) == HS_OK &&
         state.kind == given.kind &&
         hs_world_get_block_vertices(world_.get(), blocks_[block], {}, &vertices) >= HS_OK &&
         vertices == properties_of(context_, given.shape).vertex_count;
}

bool Model::has_body_of_layout(std::size_t body) const {
  const LayoutBody& given = layout_.bodies[body];
  hs_body_state state{};
  return hs_world_get_body_state(world_.get(), bodies_[body], &state, sizeof state) == HS_OK &&
         static_cast<std::size_t>(state.node_count) == given.node_count &&
         static_cast<std::size_t>(state.cell_count) == given.cell_nodes.size() &&
         (released_[body].empty() || released_[body].size() == given.node_count);
}

bool Model::is_of_layout(hs_block block) const {
  const auto known = index_of_block_.find(block);
  if (known != index_of_block_.end()) return !is_removed_[known->second];
  const auto compound = index_of_compound_.find(block);
  if (compound != index_of_compound_.end())
    return !is_removed_[layout_.compounds[compound->second].first_block];
  hs_body body = 0;
  int32_t cell = 0;
  if (hs_world_get_body_of_block(world_.get(), block, &body, &cell) != HS_OK) return false;
  const auto of_body = index_of_body_.find(body);
  return of_body != index_of_body_.end() && !is_excavated(of_body->second);
}

}  // namespace halfspace::cli
