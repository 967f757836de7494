#include "notes/assembly.h"

#include <algorithm>
#include <numeric>

namespace halfspace::cli {
namespace {

/// Blocks touch if their gap is below this fraction of the thinner one's thickness.
constexpr double touching_fraction = 1e-3;

/// Disjoint sets, each represented by its smallest member.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const auto [first, second] = std::minmax({of(i), of(j)});
    parent_[second] = first;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

Assembly::Assembly(const Start& start)
    : start_(start),
      bodies_(convex_bodies(start)),
      neighbours_(neighbours_within(start, bodies_, touching_fraction)) {
  // Cells of one body are connected by common faces, not by contact.
  std::erase_if(neighbours_, [&](const Neighbours& pair) {
    return start.layout.blocks[pair.a].body &&
           start.layout.blocks[pair.a].body == start.layout.blocks[pair.b].body;
  });
  for (const LayoutBody& body : start.layout.bodies) connect_cells(body);
  for (const LayoutCompound& compound : start.layout.compounds) {
    for (std::size_t i = 1; i < compound.part_count; ++i)
      connected_.emplace_back(compound.first_block, compound.first_block + i);
  }
  connect_bolts();
}

/// Bolts of the start and of the first stage.
void Assembly::connect_bolts() {
  std::vector<char> is_installed;
  for (const Bolt& bolt : start_.scene.bolts) is_installed.push_back(!bolt.is_installed_later);
  if (!start_.scene.stages.empty())
    for (const std::size_t bolt : start_.scene.stages[0].installed) is_installed[bolt] = 1;
  for (std::size_t i = 0; i < is_installed.size(); ++i) {
    if (!is_installed[i]) continue;
    const auto a = block_at_end(start_.scene.bolts[i], 0), b = block_at_end(start_.scene.bolts[i], 1);
    if (a && b) connected_.emplace_back(*a, *b);
    if (a.has_value() != b.has_value()) on_ground_.push_back(a ? *a : *b);
  }
}

/// Empty for the ground.
std::optional<std::size_t> Assembly::block_at_end(const Bolt& bolt, std::size_t end) const {
  const std::string& name = bolt.blocks[end];
  if (name.empty()) return start_.model.block_at(bolt.ends[end]);
  for (std::size_t i = 0; i < start_.layout.blocks.size(); ++i)
    if (start_.layout.blocks[i].name == name) return i;
  return std::nullopt;
}

void Assembly::connect_cells(const LayoutBody& body) {
  const std::size_t nodes_of_face = start_.layout.dimension == 3 ? 3 : 2;
  std::vector<std::vector<std::size_t>> cells_at(body.node_count);
  for (std::size_t cell = 0; cell < body.cell_nodes.size(); ++cell) {
    std::map<std::size_t, std::size_t> common;  // nodes in common with earlier cells
    for (const int node : body.cell_nodes[cell]) {
      for (const std::size_t other : cells_at[static_cast<std::size_t>(node)]) ++common[other];
      cells_at[static_cast<std::size_t>(node)].push_back(cell);
    }
    for (const auto& [other, count] : common) {
      if (count >= nodes_of_face) connected_.emplace_back(body.first_block + other, body.first_block + cell);
    }
  }
}

std::vector<std::size_t> Assembly::clusters(const std::vector<char>& is_gone) const {
  Sets sets(bodies_.size());
  const auto join = [&](std::size_t a, std::size_t b) {
    if (!is_gone[a] && !is_gone[b]) sets.join(a, b);
  };
  for (const Neighbours& pair : neighbours_) join(pair.a, pair.b);
  for (const auto& [a, b] : connected_) join(a, b);
  std::vector<std::size_t> first(bodies_.size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = sets.of(i);
  return first;
}

std::vector<char> Assembly::held_blocks(int axes) const {
  std::vector<char> is_held(bodies_.size());
  for (std::size_t i = 0; i < is_held.size(); ++i) {
    const LayoutBlock& block = start_.layout.blocks[i];
    is_held[i] = !moves_freely(block.kind) || (block.motion.held_axes & axes) != 0;
  }
  for (const std::size_t i : on_ground_) is_held[i] = 1;
  for (const LayoutBody& body : start_.layout.bodies) {
    std::vector<char> node_is_held(body.node_count);
    for (const LayoutBody::Support& support : body.supports) {
      if ((support.axes & axes) == 0) continue;
      for (const int32_t node : support.nodes) node_is_held[static_cast<std::size_t>(node)] = 1;
    }
    for (std::size_t cell = 0; cell < body.cell_nodes.size(); ++cell)
      is_held[body.first_block + cell] =
          std::any_of(body.cell_nodes[cell].begin(), body.cell_nodes[cell].end(),
                      [&](int node) { return node_is_held[static_cast<std::size_t>(node)] != 0; });
  }
  return is_held;
}

}  // namespace halfspace::cli
