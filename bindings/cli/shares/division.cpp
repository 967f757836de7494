#include "shares/division.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "common/box.h"

namespace halfspace::cli {
namespace {

void divide(const std::vector<Point>& points, std::span<std::size_t> indices, std::size_t parts,
            std::vector<std::vector<std::size_t>>& divided) {
  if (parts == 1) {
    divided.emplace_back(indices.begin(), indices.end());
    return std::sort(divided.back().begin(), divided.back().end());
  }
  Box box;
  for (const std::size_t i : indices) box.add(points[i]);
  const Point sides = box.sides();
  const auto axis = std::size_t(std::max_element(sides.begin(), sides.end()) - sides.begin());
  const std::size_t half = parts / 2, cut = indices.size() * half / parts;
  const auto precedes = [&](std::size_t i, std::size_t k) {
    return std::tie(points[i][axis], i) < std::tie(points[k][axis], k);
  };
  std::nth_element(indices.begin(), indices.begin() + std::ptrdiff_t(cut), indices.end(), precedes);
  divide(points, indices.first(cut), half, divided);
  divide(points, indices.subspan(cut), parts - half, divided);
}

}  // namespace

std::vector<std::vector<std::size_t>> bisect(const std::vector<Point>& points, std::size_t parts) {
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  std::vector<std::vector<std::size_t>> divided;
  divide(points, indices, parts, divided);
  return divided;
}

}  // namespace halfspace::cli
