#include "blocks/elements/loose_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Nodes closer than this fraction of the shortest edge coincide.
constexpr double one_place = 1e-4;

class LooseNodes {
 public:
  LooseNodes(const ElementMesh& mesh, const std::vector<OuterFace>& surface)
      : mesh_(mesh), surface_(surface) {
    double shortest_edge = std::numeric_limits<double>::infinity();
    for (const OuterFace& face : surface) {
      for (std::size_t k = 0; k < face.nodes.size(); ++k) {
        order_.push_back(face.nodes[k]);
        const Point edge = minus(at(face.nodes[(k + 1) % face.nodes.size()]), at(face.nodes[k]));
        shortest_edge = std::min(shortest_edge, length(edge));
      }
    }
    tolerance_ = one_place * shortest_edge;
    std::sort(order_.begin(), order_.end());
    order_.erase(std::unique(order_.begin(), order_.end()), order_.end());
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return at(a)[0] < at(b)[0]; });
  }

  std::vector<std::string> found() {
    std::vector<std::string> texts;
    std::vector<int> twins, hanging;
    for (const int node : order_) {
      for (const int other : between(at(node), at(node)))
        if (other < node && length(minus(at(other), at(node))) <= tolerance_) twins.push_back(node);
    }
    for (const OuterFace& face : surface_) {
      Point low = at(face.nodes[0]), high = low;
      for (const int node : face.nodes) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], at(node)[axis]);
          high[axis] = std::max(high[axis], at(node)[axis]);
        }
      }
      for (const int node : between(low, high))
        if (is_inside(face, at(node))) hanging.push_back(node);
    }
    add_text(texts, twins, "at the place of another", "one node for all elements that meet there");
    add_text(texts, hanging, "in the middle of another element's face or edge", "faces that meet whole");
    return texts;
  }

 private:
  const Point& at(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }

  /// The nodes of the surface in a box.
  std::vector<int> between(const Point& low, const Point& high) const {
    std::vector<int> nodes;
    auto node = std::lower_bound(order_.begin(), order_.end(), low[0] - tolerance_,
                                 [&](int other, double x) { return at(other)[0] < x; });
    for (; node != order_.end() && at(*node)[0] <= high[0] + tolerance_; ++node) {
      bool is_between = true;
      for (const std::size_t axis : {1, 2})
        is_between = is_between && at(*node)[axis] >= low[axis] - tolerance_ &&
                     at(*node)[axis] <= high[axis] + tolerance_;
      if (is_between) nodes.push_back(*node);
    }
    return nodes;
  }

  /// True within an edge (2D) or a face (3D), away from all corners.
  bool is_inside(const OuterFace& face, const Point& p) const {
    std::vector<Point> corners;
    for (const int node : face.nodes) {
      corners.push_back(at(node));
      if (length(minus(p, corners.back())) <= tolerance_) return false;
    }
    if (corners.size() == 2) return distance_to_line(corners[0], corners[1], p) <= tolerance_;
    const Point normal = area_normal(corners);
    const Point unit = times(1 / length(normal), normal);
    if (!(std::abs(dot(unit, minus(p, corners[0]))) <= tolerance_)) return false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point along = minus(corners[(k + 1) % corners.size()], corners[k]);
      const Point inwards = times(1 / length(along), cross(unit, along));
      if (dot(inwards, minus(p, corners[k])) < -tolerance_) return false;
    }
    return true;
  }

  static double distance_to_line(const Point& a, const Point& b, const Point& p) {
    const Point along = minus(b, a);
    return length(cross(along, minus(p, a))) / length(along);
  }

  void add_text(std::vector<std::string>& texts, std::vector<int> nodes, const std::string& where,
                const std::string& usual) const {
    if (nodes.empty()) return;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    texts.push_back(std::to_string(nodes.size()) + (nodes.size() == 1 ? " node " : " nodes ") + where +
                    ", the first at " + described(at(nodes[0]), mesh_.dimension) +
                    ": elements there are not joined; usual: " + usual);
  }

  const ElementMesh& mesh_;
  const std::vector<OuterFace>& surface_;
  std::vector<int> order_;  ///< nodes of the surface along x
  double tolerance_ = 0;
};

}  // namespace

std::vector<std::string> loose_nodes(const ElementMesh& mesh, const std::vector<OuterFace>& surface) {
  if (surface.empty()) return {};
  return LooseNodes(mesh, surface).found();
}

}  // namespace halfspace::cli
