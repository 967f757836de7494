#include "blocks/rock/voronoi.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <voro++/voro++.hh>

#include "common/box.h"
#include "common/random.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// The region nearer to a site than to its neighbours.
Shape cell_of(const Context& context, const Shape& region, const std::vector<Point>& sites, std::size_t site,
              const std::vector<int>& neighbours) {
  const Point& own = sites[site];
  Shape cell;
  for (int neighbour : neighbours) {
    const Point& other = sites[static_cast<std::size_t>(neighbour)];
    const Point half_way = times(0.5, plus(own, other));
    cell = cut(context, cell ? cell : region, half_way, minus(other, own)).behind;
    if (!cell) break;
  }
  if (!cell)
    throw std::runtime_error("two Voronoi sites are too close to each other; change the seed or the count");
  return cell;
}

std::vector<Shape> cells_of(const Context& context, const Shape& region, const std::vector<Point>& sites) {
  const std::vector<std::vector<int>> neighbours = neighbouring_sites(sites, vertices_of(context, region));
  std::vector<Shape> cells;
  for (std::size_t site = 0; site < sites.size(); ++site)
    cells.push_back(cell_of(context, region, sites, site, neighbours[site]));
  return cells;
}

/// In the order of a Hilbert curve: blocks that are close get close numbers, which makes steps faster.
std::vector<Point> along_curve(const Context& context, const std::vector<Point>& sites) {
  std::vector<std::int32_t> order(sites.size());
  require(context, hs_points_order_along_curve(context.get(), 3, view_of(sites), order.data()));
  std::vector<Point> ordered;
  for (const std::int32_t i : order) ordered.push_back(sites[static_cast<std::size_t>(i)]);
  return ordered;
}

}  // namespace

std::vector<Point> random_sites(const Context& context, const Shape& region, std::int64_t count,
                                std::uint64_t seed) {
  const Box bounds = box_of(vertices_of(context, region));
  const std::vector<HalfSpace> halfspaces = halfspaces_of(context, region);
  const Point centroid = point_of(properties_of(context, region).centroid);
  const auto is_inside = [&](const Point& p) {
    return std::all_of(halfspaces.begin(), halfspaces.end(), [&](const HalfSpace& halfspace) {
      return dot(halfspace.normal, minus(p, centroid)) < halfspace.offset;
    });
  };
  const Point sides = bounds.sides();
  Random random(seed);
  std::vector<Point> sites;
  while (static_cast<std::int64_t>(sites.size()) < count) {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = bounds.low[axis] + sides[axis] * random.uniform();
    if (is_inside(p)) sites.push_back(p);
  }
  return along_curve(context, sites);
}

std::vector<std::vector<int>> neighbouring_sites(const std::vector<Point>& sites,
                                                 const std::vector<Point>& around) {
  const Box bounds = box_of(around);
  const Point sides = bounds.sides();
  const double longest = std::max({sides[0], sides[1], sides[2]});

  // Voro++ has absolute tolerances, so the sites are scaled to a box of about unit size, with a margin so
  // that none lies on a side.
  constexpr double margin = 0.125;
  const auto number_of_bins = [&](std::size_t axis) {
    constexpr double sites_in_bin = 6;  // as its manual advises
    const double even = std::cbrt(static_cast<double>(sites.size()) / sites_in_bin);
    return std::max(1, static_cast<int>(even * sides[axis] / longest));
  };
  const auto upper = [&](std::size_t axis) { return sides[axis] / longest + margin; };
  voro::container container(-margin, upper(0), -margin, upper(1), -margin, upper(2), number_of_bins(0),
                            number_of_bins(1), number_of_bins(2), false, false, false, 8);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto scaled = [&](std::size_t axis) { return (sites[i][axis] - bounds.low[axis]) / longest; };
    container.put(static_cast<int>(i), scaled(0), scaled(1), scaled(2));
  }

  voro::c_loop_all loop(container);
  voro::voronoicell_neighbor cell;
  std::vector<std::vector<int>> neighbours(sites.size());
  if (loop.start()) do {
      if (!container.compute_cell(cell, loop)) continue;
      std::vector<int>& found = neighbours[static_cast<std::size_t>(loop.pid())];
      cell.neighbors(found);
      std::erase_if(found, [](int neighbour) { return neighbour < 0; });  // sides of the box
      std::sort(found.begin(), found.end());
    } while (loop.inc());
  return neighbours;
}

std::vector<Shape> voronoi_blocks(const Context& context, const Voronoi& voronoi, const Shape& region) {
  std::vector<Point> sites = random_sites(context, region, voronoi.count, voronoi.seed);
  std::vector<Shape> cells = cells_of(context, region, sites);
  for (std::int64_t round = 0; round < voronoi.relaxation; ++round) {
    for (std::size_t i = 0; i < sites.size(); ++i)
      sites[i] = point_of(properties_of(context, cells[i]).centroid);
    cells = cells_of(context, region, sites);
  }
  return cells;
}

}  // namespace halfspace::cli
