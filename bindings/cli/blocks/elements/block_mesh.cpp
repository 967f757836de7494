#include "blocks/elements/block_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/vector.h"

namespace halfspace::cli {
namespace {

Point mean(const std::vector<Point>& points) {
  Point sum{};
  for (const Point& p : points) sum = plus(sum, p);
  return times(1 / static_cast<double>(points.size()), sum);
}

/// Nodes of a mesh, merged if they coincide to rounding: they lie in one box of a grid, or next to the border
/// of two.
class Nodes {
 public:
  Nodes(ElementMesh& mesh, double size) : mesh_(mesh), unit_(std::ldexp(size, -24)) {}

  int at(const Point& place) {
    constexpr double rounding = 0.01;  // of a box
    std::array<std::int64_t, 3> key{}, other{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      key[axis] = std::llround(place[axis] / unit_);
      const double aside = place[axis] / unit_ - static_cast<double>(key[axis]);
      other[axis] = key[axis] + (aside > 0.5 - rounding) - (aside < rounding - 0.5);
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto known = index_.find(
          {corner & 1 ? other[0] : key[0], corner & 2 ? other[1] : key[1], corner & 4 ? other[2] : key[2]});
      if (known != index_.end()) return known->second;
    }
    mesh_.nodes.push_back(place);
    return index_[key] = static_cast<int>(mesh_.nodes.size()) - 1;
  }

 private:
  ElementMesh& mesh_;
  double unit_;
  std::map<std::array<std::int64_t, 3>, int> index_;
};

/// The number of parts of half an edge of the block; 0 if the block would have too many cells.
int parts_of(double longest_edge, double cell_size, std::size_t corners, int dimension) {
  const double parts = std::max(std::ceil(0.5 * longest_edge / cell_size), 1.0);
  const double cells = static_cast<double>(corners) * std::pow(parts, dimension);
  return cells <= max_cells_of_block ? static_cast<int>(parts) : 0;
}

Point between(const Point& p, const Point& q, double weight) {
  return plus(times(1 - weight, p), times(weight, q));
}

/// A point of a quad, or of a hexahedron, at natural coordinates in [0, 1].
Point inside(const std::vector<Point>& corners, double i, double j, double k) {
  const auto of_four = [&](std::size_t first) {
    return between(between(corners[first], corners[first + 1], i),
                   between(corners[first + 3], corners[first + 2], i), j);
  };
  return corners.size() == 4 ? of_four(0) : between(of_four(0), of_four(4), k);
}

/// Divides a quad or a hexahedron into parts along each direction.
void cut(const std::vector<Point>& corners, int parts, int cell_kind, Nodes& nodes, ElementMesh& mesh) {
  const bool is_flat = corners.size() == 4;
  const auto node = [&](int i, int j, int k) {
    const double n = parts;
    return nodes.at(inside(corners, i / n, j / n, k / n));
  };
  for (int k = 0; k < (is_flat ? 1 : parts); ++k) {
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts; ++i) {
        std::vector<int> cell = {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)};
        if (!is_flat) {
          cell.insert(cell.end(), {node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                   node(i, j + 1, k + 1)});
        }
        if (cell_kind != HS_CELL_TRIANGLE) {
          mesh.cells.push_back({cell_kind, std::move(cell)});
        } else {
          mesh.cells.push_back({cell_kind, {cell[0], cell[1], cell[2]}});
          mesh.cells.push_back({cell_kind, {cell[0], cell[2], cell[3]}});
        }
      }
    }
  }
}

double longest_edge(const std::vector<Point>& corners, const std::vector<std::vector<int>>& loops) {
  double longest = 0;
  for (const std::vector<int>& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto &p = corners[static_cast<std::size_t>(loop[k])],
                 &q = corners[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
      longest = std::max(longest, length(minus(q, p)));
    }
  }
  return longest;
}

/// A face at one of its corners.
struct Wedge {
  int before, after;  ///< corners
  Point middle;       ///< of the face
};

/// The hexahedron at a corner where three faces meet, given in counter-clockwise order seen from outside.
std::vector<Point> hexahedron_at(const std::vector<Point>& corners, int corner,
                                 const std::vector<Wedge>& wedges, const Point& centroid) {
  const Point& tip = corners[static_cast<std::size_t>(corner)];
  const auto to = [&](int other) { return between(tip, corners[static_cast<std::size_t>(other)], 0.5); };
  const Wedge& first = wedges[0];
  const auto follows = [&](const Wedge& wedge) { return wedge.after == first.before; };
  const Wedge& second = *std::find_if(wedges.begin() + 1, wedges.end(), follows);
  const Wedge& third = &second == &wedges[1] ? wedges[2] : wedges[1];
  return {tip,          to(first.after), first.middle, to(first.before), to(third.after),
          third.middle, centroid,        second.middle};
}

/// Six times the volume that the corner's edges span.
double volume_at(const std::vector<Point>& box) {
  return dot(cross(minus(box[1], box[0]), minus(box[3], box[0])), minus(box[4], box[0]));
}

void add_tetrahedra(const std::vector<Point>& corners, const std::vector<int>& face, const Point& middle,
                    const Point& centroid, Nodes& nodes, ElementMesh& mesh) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Point &p = corners[static_cast<std::size_t>(face[k])],
                &q = corners[static_cast<std::size_t>(face[(k + 1) % face.size()])];
    // p, q and the middle run counter-clockwise seen from outside, so clockwise seen from the centroid.
    mesh.cells.push_back(
        {HS_CELL_TETRAHEDRON, {nodes.at(q), nodes.at(p), nodes.at(middle), nodes.at(centroid)}});
  }
}

}  // namespace

ElementMesh mesh_of_polygon(const std::vector<Point>& corners, double cell_size, int cell_kind) {
  ElementMesh mesh{.dimension = 2};
  std::vector<int> loop;
  for (std::size_t k = 0; k < corners.size(); ++k) loop.push_back(static_cast<int>(k));
  const double longest = longest_edge(corners, {loop});
  const int parts = parts_of(longest, cell_size, corners.size(), 2);
  const Point centroid = mean(corners);
  Nodes nodes(mesh, longest);
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point after = between(corners[k], corners[(k + 1) % n], 0.5);
    const Point before = between(corners[k], corners[(k + n - 1) % n], 0.5);
    cut({corners[k], after, centroid, before}, parts, cell_kind, nodes, mesh);
  }
  return mesh;
}

ElementMesh mesh_of_polyhedron(const std::vector<Point>& corners, const std::vector<std::vector<int>>& faces,
                               double cell_size) {
  ElementMesh mesh{.dimension = 3};
  const double longest = longest_edge(corners, faces);
  const Point centroid = mean(corners);
  Nodes nodes(mesh, longest);
  std::vector<Point> middles;
  std::vector<std::vector<Wedge>> wedges(corners.size());
  for (const std::vector<int>& face : faces) {
    std::vector<Point> loop;
    for (const int corner : face) loop.push_back(corners[static_cast<std::size_t>(corner)]);
    middles.push_back(mean(loop));
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k)
      wedges[static_cast<std::size_t>(face[k])].push_back(
          {face[(k + n - 1) % n], face[(k + 1) % n], middles.back()});
  }
  const bool is_simple =
      std::all_of(wedges.begin(), wedges.end(), [](const std::vector<Wedge>& at) { return at.size() == 3; });
  if (!is_simple) {
    for (std::size_t f = 0; f < faces.size(); ++f)
      add_tetrahedra(corners, faces[f], middles[f], centroid, nodes, mesh);
    return mesh;
  }
  const int parts = parts_of(longest, cell_size, corners.size(), 3);
  for (std::size_t corner = 0; corner < corners.size() && parts > 0; ++corner) {
    std::vector<Point> box = hexahedron_at(corners, static_cast<int>(corner), wedges[corner], centroid);
    if (volume_at(box) < 0) box = {box[0], box[3], box[2], box[1], box[4], box[7], box[6], box[5]};
    cut(box, parts, HS_CELL_HEXAHEDRON, nodes, mesh);
  }
  return mesh;
}

}  // namespace halfspace::cli
