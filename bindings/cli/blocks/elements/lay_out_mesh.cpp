#include "blocks/elements/lay_out_mesh.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "blocks/elements/element_mesh.h"
#include "blocks/elements/loose_nodes.h"
#include "blocks/mesh/mesh_fault.h"
#include "common/files.h"
#include "common/text.h"
#include "common/vector.h"
#include "model/placing.h"

namespace halfspace::cli {
namespace {

/// A node of the mesh in one of its bodies.
struct NodeOfBody {
  std::size_t body;
  int32_t node;
};

class MeshLayout {
 public:
  MeshLayout(const Context& context, const Mesh& given, ElementMesh mesh, bool is_excavated, Faults& faults)
      : context_(context),
        given_(given),
        mesh_(std::move(mesh)),
        is_excavated_(is_excavated),
        faults_(faults),
        surface_(surface_of(mesh_)) {
    for (const Point& node : mesh_.nodes) placed_.push_back(placed(node, given.placing));
  }

  LaidOutMesh whole() {
    choose_materials();
    choose_bodies();
    if (!given_.file.empty()) note_file();
    make_bodies();
    hold();
    load();
    add_viscous();
    if (!faults_.none()) return {};
    LaidOutMesh whole{.bodies = std::move(bodies_), .groups = {}};
    for (const ElementMesh::Group& group : mesh_.groups)
      if (!group.cells.empty()) whole.groups.emplace_back(group.name, group.cells);
    return whole;
  }

 private:
  /// Elements of one body have to share nodes; those of different bodies need not.
  void note_file() {
    std::vector<std::string> notes = mesh_.notes;
    std::map<std::size_t, std::vector<OuterFace>> surfaces;  // of bodies of several elements
    if (given_.division != MeshDivision::cells)
      for (const OuterFace& face : surface_)
        surfaces[body_of_[static_cast<std::size_t>(face.cell)]].push_back(face);
    for (const auto& [body, surface] : surfaces)
      for (const std::string& text : loose_nodes(mesh_, surface))
        notes.push_back(std::filesystem::path(given_.file).filename().string() + ": " + text);
    for (const std::string& text : notes) faults_.note(given_.shape_place, given_.making.key + ".file", text);
  }

  void fault(const MeshPart& part, const std::string& text) { faults_.add(part.place, part.key, text); }

  /// Null, with a fault, if there is no such group.
  const ElementMesh::Group* find(const MeshPart& part) {
    const ElementMesh::Group* group = mesh_.group(part.group);
    if (group || part.group.empty()) return group;
    std::string known;
    for (const ElementMesh::Group& other : mesh_.groups) known += (known.empty() ? "" : ", ") + other.name;
    fault(part, "no such group: \"" + part.group +
                    "\"; allowed: " + (known.empty() ? "none, as the mesh has no group" : known));
    return nullptr;
  }

  void choose_materials() {
    materials_.assign(mesh_.cells.size(), given_.making.material);
    for (const MeshMaterial& other : given_.materials) {
      const ElementMesh::Group* group = find(other.part);
      if (group && group->cells.empty())
        fault(other.part, "no cell is in this group; allowed: a group of cells");
      if (!group) continue;
      for (const int cell : group->cells) materials_[static_cast<std::size_t>(cell)] = other.material;
    }
  }

  /// Cells in the same groups, or in none, form one body.
  void choose_bodies() {
    body_of_.assign(mesh_.cells.size(), 0);
    if (given_.division == MeshDivision::cells) {
      for (std::size_t i = 0; i < body_of_.size(); ++i) body_of_[i] = i;
    } else if (given_.division == MeshDivision::groups) {
      std::vector<std::vector<int>> groups_of(mesh_.cells.size());
      for (std::size_t g = 0; g < mesh_.groups.size(); ++g) {
        for (const int cell : mesh_.groups[g].cells)
          groups_of[static_cast<std::size_t>(cell)].push_back(static_cast<int>(g));
      }
      std::map<std::vector<int>, std::size_t> known;
      for (std::size_t i = 0; i < body_of_.size(); ++i)
        body_of_[i] = known.emplace(groups_of[i], known.size()).first->second;
    }
  }

  void make_bodies() {
    std::vector<std::vector<std::size_t>> cells_of(*std::max_element(body_of_.begin(), body_of_.end()) + 1);
    for (std::size_t i = 0; i < body_of_.size(); ++i) cells_of[body_of_[i]].push_back(i);
    where_.resize(mesh_.nodes.size());
    std::vector<std::vector<std::vector<int>>> outer_faces(mesh_.cells.size());
    if (mesh_.dimension == 3) {
      for (const OuterFace& face : outer_faces_of_bodies())
        outer_faces[static_cast<std::size_t>(face.cell)].push_back(face.nodes);
    }
    for (std::size_t body = 0; body < cells_of.size(); ++body) make_body(body, cells_of[body], outer_faces);
  }

  /// The surface of a whole mesh; all faces if it is divided or may be excavated.
  std::vector<OuterFace> outer_faces_of_bodies() const {
    if (given_.division == MeshDivision::whole && !is_excavated_) return surface_;
    std::vector<OuterFace> faces;
    for (std::size_t i = 0; i < mesh_.cells.size(); ++i) {
      for (const std::vector<int>& face : form_of_cell(mesh_.cells[i].kind).faces) {
        OuterFace& outer = faces.emplace_back(OuterFace{.cell = static_cast<int>(i), .nodes = {}});
        for (const int corner : face)
          outer.nodes.push_back(mesh_.cells[i].nodes[static_cast<std::size_t>(corner)]);
      }
    }
    return faces;
  }

  void make_body(std::size_t index, const std::vector<std::size_t>& cells,
                 const std::vector<std::vector<std::vector<int>>>& outer_faces) {
    LaidOutBody& made = bodies_.emplace_back();
    LayoutBody& body = made.body;
    std::vector<Point> nodes;
    std::vector<int32_t> kinds, cell_nodes;
    for (const std::size_t i : cells) {
      const ElementMesh::Cell& cell = mesh_.cells[i];
      kinds.push_back(cell.kind);
      body.materials.push_back(materials_[i]);
      body.cell_sizes.push_back(size_of(mesh_, cell));
      std::vector<int>& own = body.cell_nodes.emplace_back();
      for (const int node : cell.nodes) own.push_back(use(node, index, nodes));
      cell_nodes.insert(cell_nodes.end(), own.begin(), own.end());
      made.cells.push_back({.number = static_cast<int>(i),
                            .shape = {},
                            .faces = faces_of(cell, outer_faces[i]),
                            .material = materials_[i]});
    }
    hs_mesh* handle = nullptr;
    require(context_, hs_mesh_create(context_.get(), mesh_.dimension, view_of(std::as_const(nodes)),
                                     kinds.data(), static_cast<int64_t>(kinds.size()), cell_nodes.data(),
                                     static_cast<int64_t>(cell_nodes.size()), &handle));
    body.mesh.reset(handle);
    body.node_count = nodes.size();
    body.placing = given_.placing;
    body.velocity = given_.velocity;
    body.stress = given_.making.stress;
    body.stress_by_height = given_.stress_by_height;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::vector<Point> corners = mesh_.corners_of(mesh_.cells[cells[k]]);
      made.cells[k].shape =
          mesh_.dimension == 2 ? make_polygon(context_, corners) : make_hull(context_, corners);
    }
  }

  /// The node's index in a body; adds the node on its first use.
  int use(int node, std::size_t body, std::vector<Point>& nodes) {
    std::vector<NodeOfBody>& places = where_[static_cast<std::size_t>(node)];
    if (places.empty() || places.back().body != body) {
      places.push_back({body, static_cast<int32_t>(nodes.size())});
      nodes.push_back(mesh_.nodes[static_cast<std::size_t>(node)]);
    }
    return places.back().node;
  }

  /// Face loops of a cell, as indices into its nodes.
  std::vector<std::vector<int>> faces_of(const ElementMesh::Cell& cell,
                                         const std::vector<std::vector<int>>& outer) const {
    std::vector<std::vector<int>> faces;
    if (mesh_.dimension == 2) {
      faces.emplace_back();
      for (std::size_t k = 0; k < cell.nodes.size(); ++k) faces[0].push_back(static_cast<int>(k));
    }
    for (const std::vector<int>& face : outer) {
      faces.emplace_back();
      for (const int node : face)
        faces.back().push_back(
            static_cast<int>(std::find(cell.nodes.begin(), cell.nodes.end(), node) - cell.nodes.begin()));
    }
    return faces;
  }

  bool is_in(const MeshPart& part, int node) const {
    const Point& p = placed_[static_cast<std::size_t>(node)];
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(mesh_.dimension); ++axis)
      if (p[axis] < (*part.box)[0][axis] || p[axis] > (*part.box)[1][axis]) return false;
    return true;
  }

  void hold() {
    for (const MeshSupport& support : given_.supports) {
      const ElementMesh::Group* group = find(support.part);
      std::vector<int> nodes;
      if (group) nodes = group->nodes;
      if (support.part.box) {
        for (std::size_t node = 0; node < placed_.size(); ++node)
          if (is_in(support.part, static_cast<int>(node))) nodes.push_back(static_cast<int>(node));
      }
      if (nodes.empty() && (group || support.part.box))
        fault(support.part, "no node is in it; required: at least one");
      std::map<std::size_t, std::vector<int32_t>> of_bodies;
      for (const int node : nodes) {
        for (const NodeOfBody& place : where_[static_cast<std::size_t>(node)])
          of_bodies[place.body].push_back(place.node);
      }
      for (auto& [body, own] : of_bodies) support_nodes(support, bodies_[body].body, std::move(own));
    }
  }

  /// A support with a table rests before its stage.
  static void support_nodes(const MeshSupport& support, LayoutBody& body, std::vector<int32_t> nodes) {
    if (support.table.times.empty()) {
      body.supports.push_back({std::move(nodes), support.axes, support.velocity});
      return;
    }
    body.supports.push_back({nodes, support.axes, {}});
    Point scale = support.velocity;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((support.axes >> axis & 1) == 0) scale[axis] = 0;
    std::vector<Point> scales(nodes.size(), scale);
    body.actions.push_back(
        {HS_ACTION_VELOCITY, support.table, support.stage, std::move(nodes), std::move(scales)});
  }

  /// The outer faces of a part of the mesh.
  std::vector<const OuterFace*> faces_in(const MeshPart& part) {
    std::vector<const OuterFace*> faces;
    const ElementMesh::Group* group = find(part);
    std::set<std::vector<int>> missing;
    if (group) {
      for (std::vector<int> nodes : group->faces) {
        std::sort(nodes.begin(), nodes.end());
        missing.insert(std::move(nodes));
      }
    }
    for (const OuterFace& face : surface_) {
      std::vector<int> nodes = face.nodes;
      std::sort(nodes.begin(), nodes.end());
      const bool is_selected =
          part.box ? std::all_of(nodes.begin(), nodes.end(), [&](int node) { return is_in(part, node); })
                   : missing.erase(nodes) > 0;
      if (is_selected) faces.push_back(&face);
    }
    if ((group || part.box) && (faces.empty() || !missing.empty()))
      fault(part, faces.empty() ? "no outer face is in it; required: at least one"
                                : "some of its faces are inside the mesh; allowed: outer faces");
    return faces;
  }

  /// Sums the loads of the faces of a cell at its nodes.
  void load() {
    std::vector<int32_t> local(mesh_.cells.size());  // each cell's index in its body
    std::vector<int32_t> count(bodies_.size());
    for (std::size_t i = 0; i < mesh_.cells.size(); ++i) local[i] = count[body_of_[i]]++;
    std::map<int, std::map<int32_t, Point>> forces;  // of cells
    for (const MeshLoad& load : given_.loads) {
      if (load.table.times.empty()) {
        for (const OuterFace* face : faces_in(load.part)) add_forces(load, *face, forces[face->cell]);
      } else {
        load_in_time(load);
      }
    }
    for (const auto& [cell, of_nodes] : forces) {
      const auto index = static_cast<std::size_t>(cell);
      for (const auto& [node, force] : of_nodes)
        bodies_[body_of_[index]].body.forces.push_back({local[index], node, force});
    }
  }

  void load_in_time(const MeshLoad& load) {
    std::map<std::size_t, std::map<int32_t, Point>> forces;  // of bodies
    for (const OuterFace* face : faces_in(load.part))
      add_forces(load, *face, forces[body_of_[static_cast<std::size_t>(face->cell)]]);
    for (const auto& [body, of_nodes] : forces) {
      LayoutBody::NodeAction action{HS_ACTION_FORCE, load.table, load.stage, {}, {}};
      for (const auto& [node, force] : of_nodes) {
        action.nodes.push_back(node);
        action.scales.push_back(force);
      }
      bodies_[body].body.actions.push_back(std::move(action));
    }
  }

  /// The consistent nodal forces of a uniform load on a face.
  void add_forces(const MeshLoad& load, const OuterFace& face, std::map<int32_t, Point>& forces) const {
    for_each_share(face, [&](int32_t node, double weight, const Point& area) {
      Point& force = forces[node];
      force =
          plus(force, times(weight, plus(times(-load.pressure, area), times(length(area), load.traction))));
    });
  }

  /// Calls `visit(node, weight, area)` for each part of a face that belongs to a node: a half at each end of
  /// an edge, a third at each corner of a triangle; for a quad the mean over its two triangulations.
  template <class Visit>
  void for_each_share(const OuterFace& face, Visit visit) const {
    const std::size_t body = body_of_[static_cast<std::size_t>(face.cell)];
    const std::size_t n = face.nodes.size();
    const auto at = [&](std::size_t k) { return placed_[static_cast<std::size_t>(face.nodes[k % n])]; };
    const auto add = [&](std::size_t k, double weight, const Point& area) {
      for (const NodeOfBody& place : where_[static_cast<std::size_t>(face.nodes[k % n])])
        if (place.body == body) visit(place.node, weight, area);
    };
    if (n == 2) {
      const Point along = minus(at(1), at(0));
      for (std::size_t k : {0, 1}) add(k, 0.5, {along[1], -along[0], 0});
      return;
    }
    for (std::size_t first = 0; first < n; ++first) {  // the triangle of each corner and its neighbours
      const Point area =
          times(0.5, cross(minus(at(first + 1), at(first)), minus(at(first + n - 1), at(first))));
      const double weight =
          n == 3 ? 1.0 / 9 : 1.0 / 6;  // the triangles sum to three times, or twice, the face
      for (std::size_t k : {first, first + 1, first + n - 1}) add(k, weight, area);
    }
  }

  /// The parts of viscous faces at each node.
  void add_viscous() {
    for (const MeshPart& part : given_.viscous) {
      for (const OuterFace* face : faces_in(part)) {
        const auto cell = static_cast<std::size_t>(face->cell);
        for_each_share(*face, [&](int32_t node, double weight, const Point& area) {
          bodies_[body_of_[cell]].body.viscous.push_back({node, materials_[cell], times(weight, area)});
        });
      }
    }
  }

  const Context& context_;
  const Mesh& given_;
  ElementMesh mesh_;
  bool is_excavated_;
  Faults& faults_;
  std::vector<OuterFace> surface_;
  std::vector<Point> placed_;
  std::vector<int32_t> materials_;
  std::vector<std::size_t> body_of_;  ///< of each cell
  std::vector<std::vector<NodeOfBody>> where_;
  std::vector<LaidOutBody> bodies_;
};

ElementMesh read_file(const Mesh& given, int dimension) {
  const std::filesystem::path path(given.file);
  return mesh_of_file(read_gmsh(path.filename().string(), content_of(given.file)), given.scale, dimension);
}

}  // namespace

LaidOutMesh lay_out_block(const Context& context, const Making& making, const ElementMesh& cells,
                          const Placing& placing, const Point& velocity, bool is_excavated, Faults& faults) {
  Mesh mesh;
  mesh.making = making;
  mesh.placing = placing;
  mesh.velocity = velocity;
  return MeshLayout(context, mesh, cells, is_excavated, faults).whole();
}

LaidOutMesh lay_out_mesh(const Context& context, const Mesh& mesh, int dimension, bool is_excavated,
                         Faults& faults) {
  const std::string key = mesh.making.key + (mesh.box ? ".box" : ".file");
  const auto fault = [&](const std::string& text) {
    faults.add(mesh.shape_place, key, text);
    return LaidOutMesh{};
  };
  if (!mesh.box && !std::filesystem::is_regular_file(mesh.file))
    return fault("no such file: " + mesh.file + "; allowed: a Gmsh file, named from the folder of the scene");
  try {
    ElementMesh cells =
        mesh.box ? mesh_of_box((*mesh.box)[0], (*mesh.box)[1], mesh.counts, mesh.cell_kind, dimension)
                 : read_file(mesh, dimension);
    return MeshLayout(context, mesh, std::move(cells), is_excavated, faults).whole();
  } catch (const MeshFault& error) {
    return fault(error.what());
  } catch (const LibraryError& error) {
    return fault(error.reason());
  }
}

}  // namespace halfspace::cli
