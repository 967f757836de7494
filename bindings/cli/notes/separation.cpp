#include "notes/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace halfspace::cli {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Min and max coordinate of a body along a direction.
std::pair<double, double> reach_along(const ConvexBody& body, const Point& direction) {
  std::pair<double, double> reach{infinity, -infinity};
  for (const Point& p : body.vertices) {
    const double place = dot(direction, p);
    reach = {std::min(reach.first, place), std::max(reach.second, place)};
  }
  return reach;
}

std::vector<Point> normals_of(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                              int dimension) {
  std::vector<Point> normals;
  const auto add = [&](const Point& normal) {
    if (length(normal) > 0) normals.push_back(times(1 / length(normal), normal));
  };
  for (const std::vector<int>& face : faces) {
    std::vector<Point> loop;
    for (const int corner : face) loop.push_back(vertices[static_cast<std::size_t>(corner)]);
    if (dimension == 3) add(area_normal(loop));
    for (std::size_t i = 0; dimension == 2 && i < loop.size(); ++i) {
      const Point along = minus(loop[(i + 1) % loop.size()], loop[i]);
      add({along[1], -along[0], 0});
    }
  }
  return normals;
}

/// The axis along which the lower bounds of the blocks differ most.
std::size_t longest_axis(const std::vector<ConvexBody>& bodies) {
  std::size_t longest = 0;
  double largest = -infinity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = infinity, high = -infinity;
    for (const ConvexBody& body : bodies) {
      low = std::min(low, body.low[axis]);
      high = std::max(high, body.low[axis]);
    }
    if (high - low <= largest) continue;
    largest = high - low;
    longest = axis;
  }
  return longest;
}

}  // namespace

std::vector<ConvexBody> convex_bodies(const Start& start) {
  std::vector<ConvexBody> bodies;
  for (std::size_t i = 0; i < start.layout.blocks.size(); ++i) {
    ConvexBody& body = bodies.emplace_back();
    body.vertices = start.frame.blocks[i].vertices;
    for (const Point& normal :
         normals_of(body.vertices, start.layout.blocks[i].faces, start.layout.dimension))
      body.faces.push_back({normal, reach_along(body, normal).second});
    body.low = {infinity, infinity, infinity};
    body.high = {-infinity, -infinity, -infinity};
    for (const Point& p : body.vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        body.low[axis] = std::min(body.low[axis], p[axis]);
        body.high[axis] = std::max(body.high[axis], p[axis]);
      }
    }
  }
  return bodies;
}

double separation(const ConvexBody& a, const ConvexBody& b) {
  double largest = -infinity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.low[axis] == a.high[axis] && b.low[axis] == b.high[axis]) continue;  // 2D
    largest = std::max({largest, a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]});
  }
  for (const HalfSpace& face : a.faces)
    largest = std::max(largest, reach_along(b, face.normal).first - face.offset);
  for (const HalfSpace& face : b.faces)
    largest = std::max(largest, reach_along(a, face.normal).first - face.offset);
  return largest;
}

std::vector<Neighbours> neighbours_within(const Start& start, const std::vector<ConvexBody>& bodies,
                                          double fraction) {
  const std::size_t along = longest_axis(bodies);
  std::vector<std::size_t> order(bodies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return bodies[i].low[along] < bodies[j].low[along]; });
  std::vector<Neighbours> found;
  std::vector<std::size_t> open;  // blocks that the sweep has reached and not passed
  for (const std::size_t i : order) {
    const auto reach = [&](std::size_t j) {
      return fraction * std::min(start.bodies[i].thickness, start.bodies[j].thickness);
    };
    std::erase_if(open, [&](std::size_t j) {
      return bodies[j].high[along] + fraction * start.bodies[j].thickness < bodies[i].low[along];
    });
    for (const std::size_t j : open) {
      bool may_meet = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        may_meet = may_meet && bodies[i].low[axis] - bodies[j].high[axis] <= reach(j) &&
                   bodies[j].low[axis] - bodies[i].high[axis] <= reach(j);
      if (!may_meet) continue;
      const double apart = separation(bodies[i], bodies[j]);
      if (apart <= reach(j)) found.push_back({std::min(i, j), std::max(i, j), apart});
    }
    open.push_back(i);
  }
  return found;
}

}  // namespace halfspace::cli
