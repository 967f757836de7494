#include "blocks/elements/element_mesh.h"

#include <algorithm>
#include <map>

#include "blocks/mesh/mesh_fault.h"
#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Lists every node once, in ascending order.
void tidy(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Numbers the nodes that cells use.
class UsedNodes {
 public:
  UsedNodes(const GmshFile& file, double scale) : file_(file), scale_(scale), index_(file.nodes.size(), -1) {}

  int use(int node, ElementMesh& mesh) {
    int& index = index_[static_cast<std::size_t>(node)];
    if (index < 0) {
      index = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(times(scale_, file_.nodes[static_cast<std::size_t>(node)]));
    }
    return index;
  }
  /// Empty if any of them is in no cell.
  std::optional<std::vector<int>> find(const std::vector<int>& nodes) const {
    std::vector<int> found;
    for (const int node : nodes) {
      found.push_back(index_[static_cast<std::size_t>(node)]);
      if (found.back() < 0) return std::nullopt;
    }
    return found;
  }

 private:
  const GmshFile& file_;
  double scale_;
  std::vector<int> index_;
};

/// Elements of a file that are of one unusual kind.
struct Oddities {
  void add(const GmshFile::Element& element) {
    if (!first) first = &element;
    ++count;
  }
  void note(const GmshFile& file, const std::string& text, ElementMesh& mesh) const {
    if (!first) return;
    mesh.notes.push_back(file.place(*first) + ": " + std::to_string(count) +
                         (count == 1 ? " element " : " elements ") + text);
  }
  const GmshFile::Element* first = nullptr;
  std::size_t count = 0;
};

/// True for a cell without a new group: a file may list an element once for each of its groups.
bool is_repeated(const std::vector<int>& groups, std::vector<int>& known) {
  const bool is_new = std::any_of(groups.begin(), groups.end(), [&](int group) {
    return std::find(known.begin(), known.end(), group) == known.end();
  });
  known.insert(known.end(), groups.begin(), groups.end());
  return !is_new;
}

void require_level(const GmshFile& file, const ElementMesh& mesh) {
  for (const Point& node : mesh.nodes) {
    if (node[2] != mesh.nodes[0][2])
      throw MeshFault(file.name, "nodes at different z, " + shortest(mesh.nodes[0][2]) + " and " +
                                     shortest(node[2]) + "; allowed in 2D: a mesh in a plane z = constant");
  }
}

}  // namespace

const ElementMesh::Group* ElementMesh::group(const std::string& name) const {
  const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const Group& group) { return group.name == name; });
  return found == groups.end() ? nullptr : &*found;
}

std::vector<Point> ElementMesh::corners_of(const Cell& cell) const {
  std::vector<Point> corners;
  for (const int node : cell.nodes) corners.push_back(nodes[static_cast<std::size_t>(node)]);
  return corners;
}

std::vector<OuterFace> surface_of(const ElementMesh& mesh) {
  std::map<std::vector<int>, std::pair<OuterFace, int>> faces;  // with the number of its cells
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const ElementMesh::Cell& cell = mesh.cells[i];
    for (const std::vector<int>& face : form_of_cell(cell.kind).faces) {
      OuterFace outer{.cell = static_cast<int>(i), .nodes = {}};
      for (const int corner : face) outer.nodes.push_back(cell.nodes[static_cast<std::size_t>(corner)]);
      std::vector<int> key = outer.nodes;
      tidy(key);
      ++faces.emplace(std::move(key), std::pair(std::move(outer), 0)).first->second.second;
    }
  }
  std::vector<OuterFace> surface;
  for (auto& [key, face] : faces)
    if (face.second == 1) surface.push_back(std::move(face.first));
  return surface;
}

double size_of(const ElementMesh& mesh, const ElementMesh::Cell& cell) {
  const std::vector<Point> corners = mesh.corners_of(cell);
  if (form_of_cell(cell.kind).dimension == 2) return 0.5 * area_normal(corners)[2];
  double volume = 0;
  for (const std::vector<int>& face : form_of_cell(cell.kind).faces) {
    std::vector<Point> loop;
    for (const int corner : face)
      loop.push_back(minus(corners[static_cast<std::size_t>(corner)], corners[0]));
    Point middle{};
    for (const Point& p : loop) middle = plus(middle, times(1 / static_cast<double>(loop.size()), p));
    volume += dot(middle, area_normal(loop)) / 6;
  }
  return volume;
}

ElementMesh mesh_of_file(const GmshFile& file, double scale, int dimension) {
  ElementMesh mesh{.dimension = dimension};
  UsedNodes used(file, scale);
  std::vector<int> cell_of(file.elements.size(), -1);
  std::map<std::vector<int>, int> known;  // cells by their nodes: a file may list one for each of its groups
  std::vector<std::vector<int>> groups_of;  // groups of each cell
  Oddities repeated, clockwise;
  for (std::size_t i = 0; i < file.elements.size(); ++i) {
    const GmshFile::Element& element = file.elements[i];
    if (element.form->dimension != dimension) continue;
    if (element.form->cell_kind == ElementForm::no_cell)
      throw MeshFault(file.place(element), "a pyramid; allowed: tetrahedra, hexahedra and prisms");
    std::vector<int> key = element.nodes;
    std::sort(key.begin(), key.end());
    const auto [same, is_new] = known.emplace(std::move(key), static_cast<int>(mesh.cells.size()));
    cell_of[i] = same->second;
    if (is_new) {
      groups_of.push_back(element.groups);
    } else {
      if (is_repeated(element.groups, groups_of[static_cast<std::size_t>(same->second)]))
        repeated.add(element);
      continue;
    }
    ElementMesh::Cell cell{.kind = element.form->cell_kind, .nodes = {}};
    for (const int node : element.nodes) cell.nodes.push_back(used.use(node, mesh));
    if (dimension == 2 && size_of(mesh, cell) < 0) {
      std::reverse(cell.nodes.begin() + 1, cell.nodes.end());
      clockwise.add(element);
    }
    if (!(size_of(mesh, cell) > 0))
      throw MeshFault(file.place(element),
                      dimension == 2 ? "a cell without an area" : "a cell that is flat or inside out");
    mesh.cells.push_back(std::move(cell));
  }
  if (mesh.cells.empty()) {
    throw MeshFault(file.name, dimension == 2 ? "no cell; allowed in 2D: triangles and quadrangles"
                                              : "no cell; allowed in 3D: tetrahedra, hexahedra and prisms");
  }
  if (dimension == 2) require_level(file, mesh);
  repeated.note(file, "with the nodes of an earlier one: left out; usual: each element once", mesh);
  clockwise.note(file, "inside out: reversed; usual: nodes counter-clockwise", mesh);
  std::map<std::string, std::size_t> index_of;
  for (const std::string& name : file.groups) {
    if (index_of.emplace(name, mesh.groups.size()).second) mesh.groups.push_back({.name = name});
  }
  for (std::size_t i = 0; i < file.elements.size(); ++i) {
    const GmshFile::Element& element = file.elements[i];
    const std::optional<std::vector<int>> nodes = used.find(element.nodes);
    if (!nodes) continue;
    for (const int index : element.groups) {
      ElementMesh::Group& group = mesh.groups[index_of[file.groups[static_cast<std::size_t>(index)]]];
      group.nodes.insert(group.nodes.end(), nodes->begin(), nodes->end());
      if (cell_of[i] >= 0) {
        group.cells.push_back(cell_of[i]);
      } else if (element.form->dimension == dimension - 1) {
        group.faces.push_back(*nodes);
      }
    }
  }
  for (ElementMesh::Group& group : mesh.groups) tidy(group.nodes);
  return mesh;
}

}  // namespace halfspace::cli
