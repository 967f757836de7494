#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "halfspace/halfspace.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The library refused a call; the text is the library's own.
class LibraryError : public std::runtime_error {
 public:
  LibraryError(hs_status status, const std::string& text) : std::runtime_error(text), status(status) {}
  /// The text without the name of the function.
  std::string reason() const;
  hs_status status;
};

struct DestroyOwned {
  bool is_owner = true;
  void operator()(hs_context* context) const {
    if (is_owner) hs_context_destroy(context);
  }
};

struct Destroy {
  void operator()(hs_shape* shape) const { hs_shape_destroy(shape); }
  void operator()(hs_world* world) const { hs_world_destroy(world); }
  void operator()(hs_mesh* mesh) const { hs_mesh_destroy(mesh); }
};

using Context = std::unique_ptr<hs_context, DestroyOwned>;
using Shape = std::unique_ptr<hs_shape, Destroy>;
using MeshHandle = std::unique_ptr<hs_mesh, Destroy>;
using World = std::unique_ptr<hs_world, Destroy>;

/// @throws LibraryError if the status is an error
void require(const Context& context, hs_status status);

/// A context whose worlds use so many threads.
Context make_context(int threads = 1);

/// A context that another part of the program owns.
inline Context borrowed(hs_context* context) { return Context(context, DestroyOwned{false}); }

/// Views of points stored one after another; they must outlive the view.
hs_view view_of(const std::vector<Point>& points);
hs_mutable_view view_of(std::vector<Point>& points);

/// The half-space dot(normal, p) <= offset.
struct HalfSpace {
  Point normal{};  ///< unit length
  double offset = 0;
};

/// Faces in the format of the C API: the lengths of their loops, and the concatenated loops.
struct FaceList {
  explicit FaceList(const std::vector<std::vector<int>>& loops);
  int64_t count() const { return static_cast<int64_t>(sizes.size()); }

  std::vector<int32_t> sizes;
  std::vector<int32_t> vertices;
};

Shape make_polygon(const Context& context, const std::vector<Point>& vertices);
/// The segment of a chain that begins at the point of this index.
Shape make_boundary(const Context& context, const std::vector<Point>& chain, std::size_t index, double depth);
Shape make_polyhedron(const Context& context, const std::vector<Point>& vertices, const FaceList& faces);
Shape make_hull(const Context& context, const std::vector<Point>& points);
Shape make_from_halfspaces(const Context& context, const std::vector<HalfSpace>& halfspaces);
/// The report also has the fault of a geometry that the library refuses.
Shape make_fitted(const Context& context, const std::vector<Point>& vertices, const FaceList& facets,
                  double tolerance, hs_fit_report& report);

/// The parts of a shape behind and ahead of a plane (in 2D a line); null if there is no such part.
struct CutShape {
  Shape behind;
  Shape ahead;
};
CutShape cut(const Context& context, const Shape& shape, const Point& point, const Point& normal);

hs_shape_properties properties_of(const Context& context, const Shape& shape);
std::vector<Point> vertices_of(const Context& context, const Shape& shape);
/// Relative to the centroid.
std::vector<HalfSpace> halfspaces_of(const Context& context, const Shape& shape);
/// The faces of a polyhedron as loops of vertices, counter-clockwise seen from outside.
std::vector<std::vector<int>> faces_of(const Context& context, const Shape& shape);

/// All records of a world that a function of the library gives, as hs_world_get_contacts. @throws
/// LibraryError
template <class Record>
std::vector<Record> all_records(const Context& context, const hs_world* world,
                                hs_status (*get)(const hs_world*, Record[], int64_t, int64_t*)) {
  int64_t count = 0;
  require(context, get(world, nullptr, 0, &count));
  std::vector<Record> records(static_cast<std::size_t>(count));
  require(context, get(world, records.data(), count, nullptr));
  return records;
}

/// A world as hs_world_save() writes it, and back. @throws LibraryError
std::string snapshot_of(const Context& context, const hs_world* world);
World restored(const Context& context, const std::string& snapshot);

}  // namespace halfspace::cli
