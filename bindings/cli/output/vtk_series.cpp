#include "output/vtk_series.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/vector.h"
#include "output/vtk_file.h"

namespace halfspace::cli {
namespace {

constexpr int max_frames = 1 << 30;

/// Rotation and angular velocity, which have other components in 2D than in 3D.
void add_rotation(const hs_block_state& state, VtkArray& rotation, VtkArray& spin) {
  rotation.add(rotation.components == 1 ? &state.angle : state.pose.rotation);
  spin.add(spin.components == 1 ? &state.angular_velocity[2] : state.angular_velocity);
}

void add_cell_data(const Layout& layout, const Frame& frame, const Frame& start, BlockRange blocks,
                   VtkCells& cells) {
  const bool in_plane = layout.dimension == 2;
  VtkIntegers block{"block"}, kind{"kind"}, material{"material"};
  VtkArray velocity("velocity", 3), displacement("displacement", 3), force("contact_force", 3);
  VtkArray rotation = in_plane ? VtkArray("angle", 1) : VtkArray("rotation", 4);
  VtkArray spin("angular_velocity", in_plane ? 1 : 3);
  VtkArray stress("stress", 9), strain("strain", 9);
  for (std::size_t i = blocks.begin; i < blocks.end; ++i) {
    if (is_removed(frame.blocks[i])) continue;
    const hs_block_state& now = frame.blocks[i].state;
    const hs_block_state& then = start.blocks[i].state;
    double moved[3];
    for (int axis = 0; axis < 3; ++axis) moved[axis] = now.pose.position[axis] - then.pose.position[axis];
    for (std::size_t face = 0; face < layout.blocks[i].faces.size(); ++face) {
      block.values.push_back(static_cast<std::int64_t>(i));
      kind.values.push_back(now.kind);
      material.values.push_back(now.material);
      velocity.add(now.velocity);
      displacement.add(moved);
      add_rotation(now, rotation, spin);
      force.add(now.force);
      stress.add(frame.blocks[i].deformation.stress);
      strain.add(frame.blocks[i].deformation.strain);
    }
  }
  cells.integers = {block, kind, material};
  cells.arrays = {velocity, displacement, rotation, spin, force};
  if (layout.has_deformable()) cells.arrays.insert(cells.arrays.end(), {stress, strain});
}

/// The lowest and the highest coordinates of all blocks.
std::pair<Point, Point> extent_of(const Frame& frame) {
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (const BlockFrame& block : frame.blocks) {
    for (const Point& p : block.vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
  }
  return {low, high};
}

/// Points and the faces between them.
struct Surface {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// A height map, whose border continues level to the extent of the blocks: two triangles per cell, as the
/// library divides them.
Surface map_over(const std::vector<Point>& map, const Point& low, const Point& high) {
  const auto is_of_row = [&](const Point& p) { return p[1] == map[0][1]; };
  const auto columns =
      static_cast<std::size_t>(std::find_if_not(map.begin(), map.end(), is_of_row) - map.begin());
  const std::size_t rows = map.size() / columns, width = columns + 2;
  Surface surface;
  for (std::size_t j = 0; j < rows + 2; ++j) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t row = std::clamp<std::size_t>(j, 1, rows) - 1;
      Point p = map[row * columns + std::clamp<std::size_t>(i, 1, columns) - 1];
      if (i == 0) p[0] = std::min(p[0], low[0]);
      if (i > columns) p[0] = std::max(p[0], high[0]);
      if (j == 0) p[1] = std::min(p[1], low[1]);
      if (j > rows) p[1] = std::max(p[1], high[1]);
      surface.points.push_back(p);
      if (i == 0 || j == 0) continue;
      const std::size_t here = j * width + i, below = here - width;
      surface.faces.push_back({below - 1, below, here});
      surface.faces.push_back({below - 1, here, here - 1});
    }
  }
  return surface;
}

/// The water table over the extent of the blocks. It continues level beyond the ends of a polyline.
Surface water_surface(int dimension, const Frame& frame) {
  Surface surface{.points = frame.water, .faces = {}};
  std::vector<Point>& table = surface.points;
  if (table.empty()) return surface;
  const auto [low, high] = extent_of(frame);
  if (dimension == 3 && table.size() > 3) return map_over(frame.water, low, high);
  if (dimension == 2) {
    table.insert(table.begin(), {std::min(low[0], table.front()[0]), table.front()[1], 0});
    table.push_back({std::max(high[0], table.back()[0]), table.back()[1], 0});
  } else {
    const Point normal =
        table.size() < 3 ? Point{0, 0, 1} : cross(minus(table[1], table[0]), minus(table[2], table[0]));
    table = {{low[0], low[1], 0}, {high[0], low[1], 0}, {high[0], high[1], 0}, {low[0], high[1], 0}};
    for (Point& corner : table) corner[2] = -dot(normal, minus(corner, frame.water[0])) / normal[2];
  }
  surface.faces.emplace_back(table.size());
  std::iota(surface.faces[0].begin(), surface.faces[0].end(), std::size_t{0});
  return surface;
}

}  // namespace

std::string vtk_polygons(const Layout& layout, const Frame& frame, const Frame& start, BlockRange blocks) {
  VtkCells cells{.kind = "Polys", .time = frame.time};
  for (std::size_t i = blocks.begin; i < blocks.end; ++i) {
    if (is_removed(frame.blocks[i])) continue;
    const std::size_t first = cells.points.size() / 3;
    for (const Point& p : frame.blocks[i].vertices)
      cells.points.insert(cells.points.end(), p.begin(), p.end());
    for (const std::vector<int>& face : layout.blocks[i].faces) {
      for (int vertex : face) cells.connectivity.push_back(static_cast<std::int64_t>(first) + vertex);
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
    }
  }
  add_cell_data(layout, frame, start, blocks, cells);
  return vtk_text(cells);
}

std::string vtk_contacts(const Frame& frame) {
  VtkCells cells{.kind = "Verts", .time = frame.time};
  VtkIntegers block_a{"block_a"}, block_b{"block_b"}, type{"type"};
  VtkArray force("force", 3), normal("normal", 3), normal_force("normal_force", 1), shear("shear_force", 3),
      gap("gap", 1), area("area", 1);
  for (const hs_contact& contact : frame.contacts) {
    cells.connectivity.push_back(static_cast<std::int64_t>(cells.offsets.size()));
    cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
    cells.points.insert(cells.points.end(), contact.force_point, contact.force_point + 3);
    block_a.values.push_back(static_cast<std::int64_t>(contact.block_a));
    block_b.values.push_back(static_cast<std::int64_t>(contact.block_b));
    type.values.push_back(contact.type);
    force.add(contact.force);
    normal.add(contact.normal);
    normal_force.add(contact.normal_force);
    shear.add(contact.shear_force);
    gap.add(contact.gap);
    area.add(contact.area);
  }
  cells.integers = {block_a, block_b, type};
  cells.arrays = {force, normal, normal_force, shear, gap, area};
  return vtk_text(cells);
}

std::string vtk_bolts(const Frame& frame) {
  VtkCells cells{.kind = "Lines", .time = frame.time};
  VtkIntegers bolt{"bolt"}, is_ruptured{"is_ruptured"};
  VtkArray tension("tension", 1), elongation("elongation", 1), plastic("plastic_elongation", 1);
  for (const hs_bolt& at : frame.bolts) {
    for (const double* place : {at.place_a, at.place_b}) {
      cells.connectivity.push_back(static_cast<std::int64_t>(cells.points.size() / 3));
      cells.points.insert(cells.points.end(), place, place + 3);
    }
    cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
    bolt.values.push_back(at.number);
    is_ruptured.values.push_back(at.is_ruptured);
    tension.add(at.tension);
    elongation.add(at.elongation);
    plastic.add(at.plastic_elongation);
  }
  cells.integers = {bolt, is_ruptured};
  cells.arrays = {tension, elongation, plastic};
  return vtk_text(cells);
}

std::string vtk_water(int dimension, const Frame& frame) {
  VtkCells cells{.kind = dimension == 2 ? "Lines" : "Polys", .time = frame.time};
  const Surface surface = water_surface(dimension, frame);
  for (const Point& p : surface.points) cells.points.insert(cells.points.end(), p.begin(), p.end());
  for (const std::vector<std::size_t>& face : surface.faces) {
    for (const std::size_t point : face) cells.connectivity.push_back(static_cast<std::int64_t>(point));
    cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
  }
  return vtk_text(cells);
}

void VtkSeries::add_to(Archive& archive, bool has_frames) {
  archive.add(entries_);
  archive.add(contact_entries_);
  archive.add(bolt_entries_);
  archive.add(water_entries_);
  archive.add(terrain_entries_);
  archive.add(terrain_left_);
  archive.add(count_);
  archive.require(count_ >= 0 && count_ <= max_frames, "invalid number of frames");
  if (has_frames) return;
  entries_.clear();
  contact_entries_.clear();
  bolt_entries_.clear();
  water_entries_.clear();
  terrain_entries_.clear();
  terrain_left_ = 0;
}

void VtkSeries::add(const Frame& frame, const Frame& start) {
  const auto write = [&](const std::string& name, const std::string& text, std::string& entries,
                         const char* collection) {
    directory_.write(name, text);
    entries += vtk_entry(frame.time, name);
    directory_.write(collection, vtk_collection(entries));
  };
  const BlockRange terrain{layout_.terrain_begin(), layout_.blocks.size()};
  write(frame_name(count_), vtk_polygons(layout_, frame, start, {0, terrain.begin}), entries_, "run.pvd");
  const std::size_t left =
      layout_.terrain_count -
      static_cast<std::size_t>(std::count_if(
          frame.blocks.begin() + static_cast<std::ptrdiff_t>(terrain.begin), frame.blocks.end(), is_removed));
  if (left != terrain_left_) {
    write(terrain_name(count_), vtk_polygons(layout_, frame, start, terrain), terrain_entries_,
          "terrain.pvd");
    terrain_left_ = left;
  }
  if (scene_.output.contacts)
    write(contacts_name(count_), vtk_contacts(frame), contact_entries_, "contacts.pvd");
  if (!scene_.bolts.empty()) write(bolts_name(count_), vtk_bolts(frame), bolt_entries_, "bolts.pvd");
  if (has_water(scene_))
    write(water_name(count_), vtk_water(layout_.dimension, frame), water_entries_, "water.pvd");
  ++count_;
}

}  // namespace halfspace::cli
