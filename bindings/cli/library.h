#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "halfspace/halfspace.h"
#include "scene.h"

namespace halfspace::cli {

/// The library refused a call; the text is the library's own.
class LibraryError : public std::runtime_error {
 public:
  LibraryError(hs_status status, const std::string& text) : std::runtime_error(text), status(status) {}
  hs_status status;
};

struct Destroy {
  void operator()(hs_context* context) const { hs_context_destroy(context); }
  void operator()(hs_shape* shape) const { hs_shape_destroy(shape); }
  void operator()(hs_world* world) const { hs_world_destroy(world); }
};

using Context = std::unique_ptr<hs_context, Destroy>;
using Shape = std::unique_ptr<hs_shape, Destroy>;
using World = std::unique_ptr<hs_world, Destroy>;

/// @throws LibraryError if the status is an error
void require(const Context& context, hs_status status);

Context make_context();

/// Views of points stored one after another; they must outlive the view.
hs_view view_of(const std::vector<Point>& points);
hs_mutable_view view_of(std::vector<Point>& points);

Shape make_polygon(const Context& context, const std::vector<Point>& vertices);
hs_shape_properties properties_of(const Context& context, const Shape& shape);
std::vector<Point> vertices_of(const Context& context, const Shape& shape);

}  // namespace halfspace::cli
