#include <algorithm>

#include "common/text.h"
#include "common/vector.h"
#include "model/model.h"

// Water and bolts of a model.

namespace halfspace::cli {
namespace {

double between(double before, double after, double progress) {
  return (1 - progress) * before + progress * after;
}

/// The corners of a table, or a level at the corners of another one.
Point corner_of(const Water& water, const Water& other, std::size_t corner, std::size_t up) {
  if (water.table.size() > 1 || other.table.size() == 1) return water.table[corner];
  Point at = other.table[corner];
  at[up] = water.table[0][up];
  return at;
}

/// Water rises from a dry world by its factor, else by the heights of its table.
Water water_between(const std::optional<Water>& before, const Water& after, double progress, std::size_t up) {
  Water water = after;
  if (progress == 1) return water;
  if (!before) {
    water.def.factor *= progress;
    return water;
  }
  water.def.factor = between(before->def.factor, after.def.factor, progress);
  water.def.density = between(before->def.density, after.def.density, progress);
  water.table.resize(std::max(before->table.size(), after.table.size()));
  water.def.columns = std::max(before->def.columns, after.def.columns);
  for (std::size_t i = 0; i < water.table.size(); ++i) {
    water.table[i] = plus(times(1 - progress, corner_of(*before, after, i, up)),
                          times(progress, corner_of(after, *before, i, up)));
  }
  return water;
}

}  // namespace

/// The water at the present progress of the gradual changes.
std::optional<Water> Model::water() const {
  if (!water_) return std::nullopt;
  return water_between(water_before_, *water_, state_.progress, up_axis(layout_.dimension));
}

void Model::set_water() {
  if (const std::optional<Water> now = water())
    require(context_, hs_world_set_water(world_.get(), &now->def, view_of(now->table)));
}

std::optional<std::size_t> Model::block_at(const Point& place) const {
  hs_block block = 0;
  require(context_, hs_world_get_block_at(world_.get(), place.data(), &block));
  if (block == 0) return std::nullopt;
  return index_of(block);
}

/// The block that carries an end of a bolt; 0 for the ground. A block that had the place at the start may
/// have moved away from it by a little.
hs_block Model::block_at_end(std::size_t index, std::size_t end) const {
  const Bolt& bolt = given_bolts_[index];
  if (!bolt.blocks[end].empty()) return named_block(bolt, end);
  hs_block block = 0;
  require(context_, hs_world_get_block_at(world_.get(), bolt.ends[end].data(), &block));
  if (block == 0 && layout_.bolt_ends[index][end]) block = blocks_[*layout_.bolt_ends[index][end]];
  if (block != 0) return block;
  throw SceneFault(bolt.places[end], bolt.keys[end],
                   described(bolt.ends[end], layout_.dimension) +
                       " is outside of all blocks; allowed: a place in a block, or with blocks = [\"a\", "
                       "\"b\"], one of which may be \"ground\"");
}

/// The block that a bolt names for an end; 0 for the ground.
hs_block Model::named_block(const Bolt& bolt, std::size_t end) const {
  const std::string& name = bolt.blocks[end];
  if (name == ground_name) return 0;
  const auto found = std::find_if(layout_.blocks.begin(), layout_.blocks.end(),
                                  [&](const LayoutBlock& block) { return block.name == name; });
  const auto index = static_cast<std::size_t>(found - layout_.blocks.begin());
  if (found == layout_.blocks.end() || found->body || is_removed_[index]) {
    throw SceneFault(bolt.places[end], bolt.keys[end],
                     "no such block: \"" + name +
                         "\"; allowed: the name of a block that is not of a mesh and not excavated, or "
                         "\"ground\"");
  }
  return blocks_[index];
}

/// Installs those of the start, and looks for the named blocks of all others, so that no run stops there.
void Model::prepare_bolts() {
  for (std::size_t i = 0; i < given_bolts_.size(); ++i) {
    const Bolt& bolt = given_bolts_[i];
    if (!bolt.is_installed_later) {
      install(i);
    } else if (!bolt.blocks[0].empty()) {
      for (std::size_t end = 0; end < 2; ++end) (void)named_block(bolt, end);
    }
  }
}

void Model::install(std::size_t index) {
  const Bolt& bolt = given_bolts_[index];
  hs_bolt_def def = bolt.def;
  def.block_a = block_at_end(index, 0);
  def.block_b = block_at_end(index, 1);
  std::copy(bolt.ends[0].begin(), bolt.ends[0].end(), def.place_a);
  std::copy(bolt.ends[1].begin(), bolt.ends[1].end(), def.place_b);
  if (def.block_a == def.block_b) {
    throw SceneFault(bolt.places[1], bolt.keys[1],
                     "both ends are in one block; allowed: ends in two blocks, or one on the \"ground\"");
  }
  try {
    require(context_, hs_world_add_bolt(world_.get(), &def, &bolt_numbers_[index]));
  } catch (const LibraryError& error) {
    throw SceneFault(bolt.places[0], bolt.keys[0], error.reason());
  }
}

std::vector<hs_bolt> Model::bolts() const {
  std::vector<hs_bolt> bolts = all_records(context_, world_.get(), hs_world_get_bolts);
  for (hs_bolt& bolt : bolts)
    bolt.number = std::find(bolt_numbers_.begin(), bolt_numbers_.end(), bolt.number) - bolt_numbers_.begin();
  return bolts;
}

/// Checks that all bolts of a restored world are of the scene.
bool Model::has_bolts_of_scene() const {
  if (bolt_numbers_.size() != given_bolts_.size()) return false;
  const std::vector<hs_bolt> all = bolts();
  return std::all_of(all.begin(), all.end(), [&](const hs_bolt& bolt) {
    return static_cast<std::size_t>(bolt.number) < given_bolts_.size();
  });
}

}  // namespace halfspace::cli
