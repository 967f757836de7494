#include "block/mesh/surface.h"

#include <algorithm>

namespace halfspace {
namespace {

/// A face of a cell with the sorted indices of its nodes; -1 for a missing fourth one.
struct KeyedFace {
  std::array<std::int32_t, 4> key;
  SurfaceFace face;
};

template <int D>
Array<KeyedFace> sorted_faces(const Mesh<D>& mesh, Memory* memory) {
  Array<KeyedFace> faces(memory);
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellForm& form = form_of(mesh.kinds[cell]);
    for (int f = 0; f < face_count(form); ++f) {
      KeyedFace face{{-1, -1, -1, -1}, {std::int32_t(cell), f}};
      for (int i = 0; i < form.nodes_of_face[f]; ++i)
        face.key[std::size_t(i)] = mesh.nodes_of(cell)[std::size_t(form.faces[f][i])];
      std::sort(face.key.begin(), face.key.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const KeyedFace& a, const KeyedFace& b) {
    return a.key < b.key || (a.key == b.key && a.face.cell < b.face.cell);
  });
  return faces;
}

Polyhedron tetrahedron(const std::array<Vector<3>, 4>& corners, Memory* memory) {
  Polyhedron polyhedron(memory);
  polyhedron.vertices.assign(corners.begin(), corners.end());
  for (const auto& face : form_of(CellKind::tetrahedron).faces) {
    if (face[0] == face[1]) break;
    for (int i = 0; i < 3; ++i) polyhedron.append_corner(face[i]);
    polyhedron.end_face();
  }
  return polyhedron;
}

}  // namespace

template <int D>
Array<SurfaceFace> surface_of(const Mesh<D>& mesh, Memory* memory) {
  const Array<KeyedFace> faces = sorted_faces(mesh, memory);
  Array<SurfaceFace> surface(memory);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool is_shared = (i > 0 && faces[i - 1].key == faces[i].key) ||
                           (i + 1 < faces.size() && faces[i + 1].key == faces[i].key);
    if (!is_shared) surface.push_back(faces[i].face);
  }
  std::sort(surface.begin(), surface.end(), [](const SurfaceFace& a, const SurfaceFace& b) {
    return a.cell < b.cell || (a.cell == b.cell && a.face < b.face);
  });
  return surface;
}

template <int D>
std::int64_t cell_too_many(const Mesh<D>& mesh, Memory* memory) {
  const Array<KeyedFace> faces = sorted_faces(mesh, memory);
  for (std::size_t i = 2; i < faces.size(); ++i) {
    if (faces[i].key == faces[i - 2].key) return faces[i].face.cell;
  }
  return -1;
}

template <int D>
Array<SurfaceSimplex<D>> surface_simplices(const Mesh<D>& mesh, Memory* memory) {
  Array<SurfaceSimplex<D>> simplices(memory);
  std::size_t first_of_cell = 0;
  for (const SurfaceFace& at : surface_of(mesh, memory)) {
    const CellForm& form = form_of(mesh.kinds[std::size_t(at.cell)]);
    const int* face = form.faces[at.face];
    const int* end_of_face = face + form.nodes_of_face[at.face];
    const auto is_on_face = [&](int node) { return std::find(face, end_of_face, node) != end_of_face; };
    if (simplices.empty() || simplices.back().cell != at.cell) first_of_cell = simplices.size();
    for (int s = 0; s < form.simplex_count; ++s) {
      const int* corners = form.simplices[s];
      if (std::count_if(corners, corners + D + 1, is_on_face) < D) continue;
      SurfaceSimplex<D> simplex{at.cell, {}, 0};
      for (std::size_t i = 0; i <= D; ++i) {
        simplex.node[i] = mesh.nodes_of(std::size_t(at.cell))[std::size_t(corners[i])];
        if (!is_on_face(corners[i])) simplex.outer_faces |= 1 << i;
      }
      const auto is_same = [&](const SurfaceSimplex<D>& other) { return other.node == simplex.node; };
      const auto known =
          std::find_if(simplices.begin() + std::ptrdiff_t(first_of_cell), simplices.end(), is_same);
      if (known == simplices.end()) {
        simplices.push_back(simplex);
      } else {
        known->outer_faces |= simplex.outer_faces;
      }
    }
  }
  return simplices;
}

FaultReport check_simplex(const std::array<Vector<2>, 3>& corners, Memory*) { return check_polygon(corners); }
PolyhedronFault check_simplex(const std::array<Vector<3>, 4>& corners, Memory* memory) {
  Polyhedron polyhedron = tetrahedron(corners, memory);
  return complete_polyhedron(polyhedron);
}

Shape<2> shape_of_simplex(const std::array<Vector<2>, 3>& corners, Memory* memory) {
  return {corners, memory};
}
Shape<3> shape_of_simplex(const std::array<Vector<3>, 4>& corners, Memory* memory) {
  Polyhedron polyhedron = tetrahedron(corners, memory);
  complete_polyhedron(polyhedron);
  return {polyhedron, memory};
}

template Array<SurfaceFace> surface_of(const Mesh<2>&, Memory*);
template Array<SurfaceFace> surface_of(const Mesh<3>&, Memory*);
template std::int64_t cell_too_many(const Mesh<2>&, Memory*);
template std::int64_t cell_too_many(const Mesh<3>&, Memory*);
template Array<SurfaceSimplex<2>> surface_simplices(const Mesh<2>&, Memory*);
template Array<SurfaceSimplex<3>> surface_simplices(const Mesh<3>&, Memory*);

}  // namespace halfspace
