#include "notes/start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Min width of a shape normal to one of its faces; in 2D its min width.
double thickness_of(const Context& context, const Shape& shape) {
  const hs_shape_properties properties = properties_of(context, shape);
  const Point centroid = point_of(properties.centroid);
  const std::vector<Point> vertices = vertices_of(context, shape);
  double thickness = std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : halfspaces_of(context, shape)) {
    double farthest = 0;
    for (const Point& p : vertices) {
      farthest = std::max(farthest, face.offset - dot(face.normal, minus(p, centroid)));
      if (farthest >= thickness) break;  // the other vertices change nothing
    }
    thickness = std::min(thickness, farthest);
  }
  return thickness;
}

std::vector<Body> bodies_of(const Context& context, const Model& model, const Frame& frame) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < model.layout().blocks.size(); ++i) {
    const LayoutBlock& given = model.layout().blocks[i];
    const hs_shape_properties properties = properties_of(context, given.shape);
    const double speed =
        length(given.motion.velocity) + length(given.motion.angular_velocity) * properties.bounding_radius;
    bodies.push_back({frame.blocks[i].state, thickness_of(context, given.shape), properties.volume, speed});
  }
  return bodies;
}

}  // namespace

Start::Start(const Context& context, const Scene& scene, const Model& model)
    : context(context),
      scene(scene),
      model(model),
      layout(model.layout()),
      frame(model.frame()),
      bodies(bodies_of(context, model, frame)) {}

bool is_beyond_rounding(double depth, double thinner, const Body& a, const Body& b) {
  const double places =
      std::max(length(point_of(a.state.pose.position)), length(point_of(b.state.pose.position)));
  return depth > std::ldexp(thinner, -20) + std::ldexp(places, -44);
}

std::set<int> used_materials(const Start& start) {
  std::set<int> used;
  for (const LayoutBlock& block : start.layout.blocks) used.insert(block.material);
  return used;
}

std::string ratio_text(double ratio) {
  return ratio < 1 ? rounded(100 * ratio, 3) + " % of" : rounded(ratio, 3) + " times";
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

}  // namespace halfspace::cli
