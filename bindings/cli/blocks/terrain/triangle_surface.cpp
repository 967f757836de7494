#include "blocks/terrain/triangle_surface.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "blocks/terrain/height_map.h"
#include "common/files.h"

namespace halfspace::cli {
namespace {

/// The faces of a file, in m, each divided into triangles around its first vertex.
Surface in_triangles(Surface surface, const Terrain& terrain) {
  for (Point& vertex : surface.vertices) vertex = times(terrain.scale, vertex);
  std::vector<Surface::Face> triangles;
  for (const Surface::Face& face : surface.faces) {
    for (std::size_t i = 2; i < face.vertices.size(); ++i)
      triangles.push_back(
          {{face.vertices[0], face.vertices[i - 1], face.vertices[i]}, face.object, face.number});
  }
  surface.faces = std::move(triangles);
  return surface;
}

/// Two triangles for each square of a height map with data at its corners. The diagonals alternate, so that
/// no direction is preferred.
Surface surface_of(const HeightMap& map, const std::string& name, const Terrain& terrain) {
  const double spacing = spacing_of(map, name, terrain.spacing);
  Surface surface{.file = name, .separator = ": square ", .vertices = {}, .faces = {}};
  std::vector<int> vertex_at(map.heights.size(), -1);
  for (std::size_t row = 0; row < map.rows; ++row) {
    for (std::size_t column = 0; column < map.columns; ++column) {
      Point node = map.node(column, row, spacing);
      if (std::isnan(node[2])) continue;
      node[2] = terrain.lowest + (terrain.highest - terrain.lowest) * node[2];
      vertex_at[row * map.columns + column] = static_cast<int>(surface.vertices.size());
      surface.vertices.push_back(node);
    }
  }
  for (std::size_t row = 1; row < map.rows; ++row) {
    for (std::size_t column = 1; column < map.columns; ++column) {
      const std::size_t corner = row * map.columns + column;
      const int south_east = vertex_at[corner], south_west = vertex_at[corner - 1];
      const int north_east = vertex_at[corner - map.columns],
                north_west = vertex_at[corner - map.columns - 1];
      if (std::min({south_east, south_west, north_east, north_west}) < 0) continue;
      const int number = static_cast<int>((row - 1) * (map.columns - 1) + column);
      if ((row + column) % 2 == 0) {
        surface.faces.push_back({{south_west, south_east, north_east}, 0, number});
        surface.faces.push_back({{south_west, north_east, north_west}, 0, number});
      } else {
        surface.faces.push_back({{south_west, south_east, north_west}, 0, number});
        surface.faces.push_back({{south_east, north_east, north_west}, 0, number});
      }
    }
  }
  return surface;
}

Surface read_file(const Terrain& terrain) {
  const std::string name = std::filesystem::path(terrain.file).filename().string();
  const std::string extension = extension_of(terrain.file);
  if (extension == ".stl") return in_triangles(read_stl(name, content_of(terrain.file)), terrain);
  if (extension == ".obj") return in_triangles(read_obj(name, content_of(terrain.file)), terrain);
  if (extension == ".csv" || extension == ".asc")
    return surface_of(read_heights(name, content_of(terrain.file)), name, terrain);
  if (extension == ".png") return surface_of(read_png_heights(name, content_of(terrain.file)), name, terrain);
  throw MeshFault(name, "unknown file extension; allowed: .stl, .obj, .csv, .png, .asc");
}

/// Makes one vertex of coincident ones.
void weld(Surface& surface) {
  std::map<Point, int> index_of;
  std::vector<Point> vertices;
  std::vector<int> welded;
  for (const Point& vertex : surface.vertices) {
    const auto [entry, is_new] = index_of.emplace(vertex, static_cast<int>(vertices.size()));
    if (is_new) vertices.push_back(vertex);
    welded.push_back(entry->second);
  }
  surface.vertices = std::move(vertices);
  for (Surface::Face& face : surface.faces)
    for (int& vertex : face.vertices) vertex = welded[static_cast<std::size_t>(vertex)];
}

Point normal_of(const Surface& surface, const Surface::Face& face) {
  std::vector<Point> corners;
  for (const int vertex : face.vertices)
    corners.push_back(surface.vertices[static_cast<std::size_t>(vertex)]);
  return area_normal(corners);
}

/// Triangles steeper than this count as vertical: the blocks behind them would have no extent.
constexpr double min_up = 1e-3;  // cosine of the slope

void require_upward(const Surface& surface) {
  std::size_t count = 0;
  const Surface::Face* first = nullptr;
  for (const Surface::Face& face : surface.faces) {
    const Point normal = normal_of(surface, face);
    if (!(length(normal) > 0)) throw MeshFault(surface.place(face), "a triangle without area");
    if (normal[2] > min_up * length(normal)) continue;
    ++count;
    if (!first) first = &face;
  }
  if (count == 0) return;
  throw MeshFault(surface.place(*first),
                  "a triangle that faces down or sideways, the first of " + std::to_string(count) +
                      " among " + std::to_string(surface.faces.size()) +
                      "; allowed: triangles that face up, counter-clockwise seen from above");
}

/// As all triangles face up, two that use an edge in the same direction lie on the same side of it.
void require_manifold(const Surface& surface) {
  std::unordered_map<std::uint64_t, const Surface::Face*> face_at;
  for (const Surface::Face& face : surface.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::uint32_t>(face.vertices[i]);
      const auto to = static_cast<std::uint32_t>(face.vertices[(i + 1) % 3]);
      const auto [entry, is_new] = face_at.emplace(std::uint64_t{from} << 32 | to, &face);
      if (is_new) continue;
      std::vector<int> one = face.vertices, other = entry->second->vertices;
      std::sort(one.begin(), one.end());
      std::sort(other.begin(), other.end());
      const std::string place_of_other = surface.place(*entry->second);
      if (one == other) throw MeshFault(surface.place(face), "the same triangle as " + place_of_other);
      throw MeshFault(surface.place(face),
                      "a triangle on the same side of an edge as " + place_of_other +
                          "; allowed: a surface with at most two triangles at an edge, one on each side");
    }
  }
}

}  // namespace

TriangleSurface read_surface(const Terrain& terrain) {
  Surface surface = read_file(terrain);
  if (surface.faces.empty()) throw MeshFault(surface.file, "no triangles; required: one or more");
  for (Point& vertex : surface.vertices) vertex = plus(vertex, terrain.shift);
  weld(surface);
  require_upward(surface);
  require_manifold(surface);
  TriangleSurface result{std::move(surface.vertices), {}};
  for (const Surface::Face& face : surface.faces)
    result.triangles.push_back({face.vertices[0], face.vertices[1], face.vertices[2]});
  return result;
}

}  // namespace halfspace::cli
