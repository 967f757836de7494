#include "geometry/polyhedron/gauss_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/support.h"

namespace halfspace {
namespace {

/// The directions to the corners of a cell.
struct Cell {
  Vector<3> corner[4];

  Cell(int side, int u, int v, int cells) {
    const int axis = side / 2;
    for (int i = 0; i < 4; ++i) {
      const auto from_middle = [&](int c) { return double(2 * c - cells) / cells; };
      corner[i][axis] = side % 2 == 0 ? 1 : -1;
      corner[i][axis == 0 ? 1 : 0] = from_middle(u + i % 2);
      corner[i][axis == 2 ? 1 : 2] = from_middle(v + i / 2);
    }
  }
};

/// Finds the candidates of one cell after the other.
class Search {
 public:
  Search(const Outline<3>& outline, Memory* memory)
      : outline_(outline), seen_in_(std::size_t(outline.vertex_count()), -1, memory) {}

  /// Appends the vertices that are deepest along some direction through a cell. They are connected: as a
  /// direction rotates, the deepest vertex moves to a neighbour.
  void append_candidates(const Cell& cell, int cell_index, Array<std::int32_t>& vertices) {
    const std::size_t first = vertices.size();
    start_ = walk_to_deepest(outline_, cell.corner[0], start_).vertex;
    vertices.push_back(start_);
    seen_in_[std::size_t(start_)] = cell_index;
    for (std::size_t i = first; i < vertices.size(); ++i) {
      for (const std::int32_t neighbour : neighbours(vertices[i])) {
        if (std::exchange(seen_in_[std::size_t(neighbour)], cell_index) == cell_index) continue;
        if (is_candidate(cell, neighbour)) vertices.push_back(neighbour);
      }
    }
  }

 private:
  std::span<const std::int32_t> neighbours(std::int32_t vertex) const {
    const Topology& t = *outline_.topology;
    return {t.vertex_neighbour + t.first_of_vertex[vertex],
            t.vertex_neighbour + t.first_of_vertex[vertex + 1]};
  }

  /// Is no neighbour deeper along all directions through the cell, that is, along all of its corners?
  bool is_candidate(const Cell& cell, std::int32_t vertex) const {
    const std::span<const std::int32_t> around = neighbours(vertex);
    return std::none_of(around.begin(), around.end(), [&](std::int32_t neighbour) {
      const Vector<3> to_neighbour = outline_.vertex(neighbour) - outline_.vertex(vertex);
      return std::all_of(cell.corner, cell.corner + 4,
                         [&](const Vector<3>& direction) { return direction.dot(to_neighbour) < 0; });
    });
  }

  const Outline<3>& outline_;
  Array<int> seen_in_;  // the last cell in which a vertex was tested
  std::int32_t start_ = 0;
};

}  // namespace

GaussMap::GaussMap(const Outline<3>& outline, Memory* memory)
    : cells_(int(std::sqrt(0.25 * outline.vertex_count()))), first_of_cell_(memory), vertices_(memory) {
  Search search(outline, memory);
  first_of_cell_.reserve(std::size_t(6 * cells_ * cells_ + 1));
  for (int side = 0; side < 6; ++side) {
    for (int u = 0; u < cells_; ++u) {
      for (int v = 0; v < cells_; ++v) {
        first_of_cell_.push_back(std::int32_t(vertices_.size()));
        search.append_candidates(Cell(side, u, v, cells_), int(first_of_cell_.size()), vertices_);
      }
    }
  }
  first_of_cell_.push_back(std::int32_t(vertices_.size()));
  refit(vertices_, vertices_.size());
}

}  // namespace halfspace
