#include "output/picture/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/vector.h"

namespace halfspace::cli {
namespace {

constexpr Rgb white{255, 255, 255};
constexpr Rgb ink{27, 27, 27};

/// Height of the plane of a face over the picture: depth = at_origin + along[0] * x + along[1] * y.
struct DepthPlane {
  double at_origin;
  double along[2];
  double operator()(double x, double y) const { return at_origin + along[0] * x + along[1] * y; }
};

DepthPlane plane_of(const Point& corner, const Point& normal) {
  const double x = -normal[0] / normal[2];
  const double y = -normal[1] / normal[2];
  return {corner[2] - x * corner[0] - y * corner[1], {x, y}};
}

/// The samples of a row whose centres are inside a convex loop: the first column, and one past the last.
std::pair<int, int> columns_inside(const std::vector<Point>& corners, double y, int columns) {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    if ((a[1] <= y) == (b[1] <= y)) continue;
    const double x = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
    left = std::min(left, x);
    right = std::max(right, x);
  }
  if (!(left < right)) return {0, 0};
  const auto column = [columns](double x) {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(columns)));
  };
  return {column(left), column(right)};
}

}  // namespace

Canvas::Canvas(int width, int height)
    : columns_(width * samples),
      rows_(height * samples),
      depths_(index(0, rows_), -std::numeric_limits<float>::infinity()),
      faces_(depths_.size(), -1) {}

bool Canvas::draw(const std::vector<Point>& face, Rgb colour) {
  std::vector<Point> corners = face;
  for (Point& corner : corners) {
    corner[0] *= samples;
    corner[1] *= samples;
  }
  const Point normal = area_normal(corners);
  if (!(normal[2] < 0)) return false;
  const DepthPlane plane = plane_of(corners[0], normal);
  const auto nearer = [](std::size_t axis) {
    return [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
  };
  // The plane of a face seen edge-on is steep: depths are clamped to those of its corners.
  const auto [deepest, nearest] = std::minmax_element(corners.begin(), corners.end(), nearer(2));
  const auto [highest, lowest] = std::minmax_element(corners.begin(), corners.end(), nearer(1));
  const auto row_from = [this](double y) {
    return static_cast<int>(std::clamp(std::ceil(y - 0.5), 0.0, static_cast<double>(rows_)));
  };
  const auto number = static_cast<std::int32_t>(colours_.size());
  colours_.push_back(colour);
  for (int row = row_from((*highest)[1]); row < row_from((*lowest)[1]); ++row) {
    const auto [begin, end] = columns_inside(corners, row + 0.5, columns_);
    for (int column = begin; column < end; ++column) {
      const auto depth =
          static_cast<float>(std::clamp(plane(column + 0.5, row + 0.5), (*deepest)[2], (*nearest)[2]));
      const std::size_t sample = index(column, row);
      if (depth <= depths_[sample]) continue;
      depths_[sample] = depth;
      faces_[sample] = number;
    }
  }
  return true;
}

std::vector<Canvas::Visible> Canvas::visible_parts() const {
  std::vector<Visible> parts(colours_.size());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::int32_t face = faces_[index(column, row)];
      if (face < 0) continue;
      Visible& part = parts[static_cast<std::size_t>(face)];
      ++part.samples;
      part.sum = plus(part.sum, {(column + 0.5) / samples, (row + 0.5) / samples, 0});
    }
  }
  return parts;
}

bool Canvas::on_line(int column, int row, int line_width) const {
  const std::int32_t face = faces_[index(column, row)];
  const int last_column = std::min(column + line_width, columns_ - 1);
  const int last_row = std::min(row + line_width, rows_ - 1);
  for (int r = row; r <= last_row; ++r) {
    for (int c = column; c <= last_column; ++c) {
      if (faces_[index(c, r)] != face) return true;
    }
  }
  return false;
}

Image Canvas::image(int line_width) const {
  Image image{.width = columns_ / samples, .height = rows_ / samples, .bytes = {}};
  image.bytes.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      int sum[3] = {};
      for (int row = samples * y; row < samples * (y + 1); ++row) {
        for (int column = samples * x; column < samples * (x + 1); ++column) {
          const std::int32_t face = faces_[index(column, row)];
          Rgb colour = face < 0 ? white : colours_[static_cast<std::size_t>(face)];
          if (on_line(column, row, line_width)) colour = ink;
          sum[0] += colour.red;
          sum[1] += colour.green;
          sum[2] += colour.blue;
        }
      }
      constexpr int count = samples * samples;
      for (int part : sum) image.bytes.push_back(static_cast<std::uint8_t>((part + count / 2) / count));
    }
  }
  return image;
}

}  // namespace halfspace::cli
