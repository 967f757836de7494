#include "model/checked_shape.h"

#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "blocks/mesh/common_planes.h"
#include "blocks/mesh/convex_solid.h"
#include "blocks/mesh/file_summary.h"
#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/solid.h"
#include "blocks/rock/convex_parts.h"
#include "blocks/rock/outline.h"
#include "common/text.h"

namespace halfspace::cli {
namespace {

const char* describe(int fault) {
  switch (fault) {
    case HS_FAULT_TOO_FEW_VERTICES:
      return "fewer than 3 vertices";
    case HS_FAULT_NOT_FINITE:
      return "a coordinate too large or too small to compute with";
    case HS_FAULT_REPEATED_VERTEX:
      return "coincides with its neighbour";
    case HS_FAULT_NOT_CONVEX:
      return "a reflex corner";
    case HS_FAULT_SELF_CROSSING:
      return "the outline crosses itself or winds more than once";
    case HS_FAULT_ZERO_AREA:
      return "all vertices on one line";
    default:
      return "not a polygon";
  }
}

}  // namespace

std::vector<Shape> CheckedShapes::polygon(const std::vector<Point>& vertices, bool may_be_concave,
                                          const std::string& key, Place place) {
  std::vector<Point> corners = vertices;
  std::vector<std::size_t> numbers(vertices.size());  // of the corners
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  hs_fault fault{};
  while (true) {
    require(context_, hs_polygon_check(context_.get(), view_of(std::as_const(corners)), &fault));
    if (fault.kind != HS_FAULT_COLLINEAR_VERTEX) break;
    corners.erase(corners.begin() + fault.vertex);  // straight corners change no shape
    numbers.erase(numbers.begin() + fault.vertex);
  }
  std::vector<Shape> shapes;
  if (fault.kind == HS_FAULT_NONE) {
    shapes.push_back(make_polygon(context_, corners));
    return shapes;
  }
  std::optional<SelfContact> found;
  if (fault.kind == HS_FAULT_NOT_CONVEX || fault.kind == HS_FAULT_SELF_CROSSING)
    found = find_self_contact(vertices);
  if (!found && fault.kind == HS_FAULT_NOT_CONVEX && may_be_concave)
    return concave_polygon(corners, key, place);
  if (!found && fault.vertex >= 0)
    found = SelfContact{numbers[static_cast<std::size_t>(fault.vertex)], describe(fault.kind)};
  faults_.add(place, key,
              (found ? "vertex " + std::to_string(found->vertex) + ' ' +
                           described(vertices[found->vertex], 2) + ": " + found->text
                     : std::string(describe(fault.kind))) +
                  "; allowed: the corners of a " + (may_be_concave ? "" : "convex ") +
                  "polygon in order, which neither touches nor crosses itself");
  return shapes;
}

std::vector<Shape> CheckedShapes::concave_polygon(const std::vector<Point>& corners, const std::string& key,
                                                  Place place) {
  std::string reason = "no division between its corners";
  try {
    std::vector<Shape> shapes;
    for (const std::vector<Point>& part : convex_parts(corners))
      shapes.push_back(make_polygon(context_, part));
    if (!shapes.empty()) return shapes;
  } catch (const LibraryError& error) {
    if (error.status != HS_ERROR_ARGUMENT && error.status != HS_ERROR_GEOMETRY) throw;
    reason = error.reason();
  }
  faults_.add(place, key,
              "concave, and a convex part of it is too thin: " + reason +
                  "; allowed: corners that differ by more than rounding");
  return {};
}

Shape CheckedShapes::polyhedron(const std::vector<Point>& vertices,
                                const std::vector<std::vector<int>>& faces, std::optional<double> tolerance,
                                const std::string& key, Place place) {
  try {
    hs_fit_report report;
    if (tolerance) return make_fitted(context_, vertices, FaceList(faces), *tolerance, report);
    return faces.empty() ? make_hull(context_, vertices)
                         : make_polyhedron(context_, vertices, FaceList(faces));
  } catch (const LibraryError& error) {
    if (error.status != HS_ERROR_ARGUMENT && error.status != HS_ERROR_GEOMETRY) throw;
    faults_.add(place, key,
                error.reason() + "; allowed: " +
                    (faces.empty() ? "points that are not all in one plane"
                                   : "the corners and whole faces of a convex polyhedron"));
    return nullptr;
  }
}

std::vector<Shape> CheckedShapes::from_file(const Block& block) {
  const auto fault = [&](const std::string& text) {
    faults_.add(block.shape_place, block.making.key + ".file", text);
  };
  if (!std::filesystem::is_regular_file(block.file)) {
    fault("no such file: " + block.file + "; allowed: a file, named from the folder of the scene");
    return {};
  }
  std::vector<Solid> solids;
  try {
    solids = read_solids(block.file);
  } catch (const MeshFault& error) {
    fault(error.what());
    return {};
  }
  FileSummary summary;
  std::vector<ConvexSolid> blocks;
  for (const Solid& solid : solids) {
    try {
      ConvexSolid made = make_convex(context_, solid, block.scale, block.tolerance);
      summary.add(solid, made.report);
      blocks.push_back(std::move(made));
    } catch (const NotConvex& error) {
      summary.add(error);
    } catch (const MeshFault& error) {
      summary.add(error);
    }
  }
  for (const std::string& text : summary.faults()) fault(text);
  if (summary.faults().empty()) summary.add_flush_faces(share_planes(context_, blocks));
  for (const std::string& text : summary.notes())
    faults_.note(block.shape_place, block.making.key + ".file", text);
  if (!summary.faults().empty()) return {};
  std::vector<Shape> shapes;
  for (ConvexSolid& made : blocks) shapes.push_back(std::move(made.shape));
  if (block.is_joined) check_overlaps(block, shapes);
  return shapes;
}

/// Joined solids that overlap are a fault, as the library finds them in a world of their own.
void CheckedShapes::check_overlaps(const Block& block, const std::vector<Shape>& shapes) {
  hs_world_def world_def;
  require(context_, hs_world_def_init(&world_def, sizeof world_def, dimension_));
  hs_world* made = nullptr;
  require(context_, hs_world_create(context_.get(), &world_def, &made));
  const World world(made);
  int32_t material = 0;
  require(context_, hs_world_add_material(made, 1, &material));
  std::vector<const hs_shape*> solids;
  for (const Shape& shape : shapes) solids.push_back(shape.get());
  const auto count = static_cast<int64_t>(solids.size());
  hs_block_def def;
  require(context_, hs_compound_def_init(&def, sizeof def, solids.data(), nullptr, count));
  hs_block compound = 0;
  const hs_status status = hs_world_add_compound(made, solids.data(), nullptr, count, &def, &compound);
  try {
    require(context_, status);
  } catch (const LibraryError& error) {
    if (error.status != HS_ERROR_GEOMETRY) throw;
    faults_.add(block.shape_place, block.making.key + ".joined",
                error.reason() + "; allowed: solids that touch or are apart");
  }
}

std::vector<Shape> CheckedShapes::from_boundary(const Block& block) {
  if (!std::isfinite(block.depth)) return {};  // a fault already
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i + 1 < block.boundary.size(); ++i) {
    try {
      shapes.push_back(make_boundary(context_, block.boundary, i, block.depth));
    } catch (const LibraryError& error) {
      if (error.status != HS_ERROR_ARGUMENT && error.status != HS_ERROR_GEOMETRY) throw;
      faults_.add(block.shape_place, block.making.key + ".boundary",
                  "segment " + std::to_string(i) + ": " + error.reason() +
                      "; allowed: segments whose ends differ, by more than rounding");
      return {};
    }
  }
  return shapes;
}

std::vector<Shape> CheckedShapes::of(const Block& block) {
  if (!block.file.empty()) return from_file(block);
  if (!block.boundary.empty()) return from_boundary(block);
  if (block.vertices.empty()) return {};  // a fault already
  // A concave polygon is one block, unless it strains.
  if (dimension_ == 2)
    return polygon(block.vertices, !deforms(block.making.kind), block.making.key + ".vertices",
                   block.shape_place);
  std::vector<Shape> shapes;
  if (Shape shape = polyhedron(block.vertices, block.faces, block.tolerance, block.making.key + ".vertices",
                               block.shape_place))
    shapes.push_back(std::move(shape));
  return shapes;
}

Shape CheckedShapes::of(const Region& region) {
  if (region.points.empty()) return nullptr;  // a fault already
  if (dimension_ == 3) return polyhedron(region.points, {}, {}, region.key, region.place);
  std::vector<Shape> shapes = polygon(region.points, false, region.key, region.place);
  return shapes.empty() ? nullptr : std::move(shapes.front());
}

}  // namespace halfspace::cli
