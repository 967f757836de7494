#include "block/mesh/interpolation.h"

#include <cmath>

namespace halfspace {
namespace {

/// Corners of the square and the cube, in the order of their nodes.
constexpr double corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
/// Corners of the triangle, and the gradients of its three weights.
constexpr double sides[3][2] = {{0, 0}, {1, 0}, {0, 1}};
constexpr double rises[3][2] = {{-1, -1}, {1, 0}, {0, 1}};

double share_of_triangle(int corner, const std::array<double, 3>& at) {
  return corner == 0 ? 1 - at[0] - at[1] : at[std::size_t(corner) - 1];
}

double end_of_prism(int node) { return node < 3 ? -1 : 1; }

}  // namespace

std::array<double, 3> Interpolation::place(int node) const {
  if (is_prism_) return {sides[node % 3][0], sides[node % 3][1], end_of_prism(node)};
  const double* corner = corners[node];
  return {corner[0], corner[1], dimension() == 3 ? corner[2] : 0};
}

std::array<double, 3> Interpolation::middle() const {
  return is_prism_ ? std::array<double, 3>{1. / 3, 1. / 3, 0} : std::array<double, 3>{};
}

GaussPoint Interpolation::point(int i) const {
  const double aside = 1 / std::sqrt(3.0);
  GaussPoint point{place(i), 1};
  for (double& coordinate : point.at) coordinate *= aside;
  if (is_prism_) {
    for (std::size_t k = 0; k < 2; ++k) point.at[k] = 1. / 6 + 0.5 * sides[i % 3][k];
    point.weight = 1. / 6;
  }
  return point;
}

double Interpolation::weight(int node, const std::array<double, 3>& at) const {
  if (is_prism_) return share_of_triangle(node % 3, at) * 0.5 * (1 + end_of_prism(node) * at[2]);
  double weight = 1;
  for (int k = 0; k < dimension(); ++k) weight *= 0.5 * (1 + corners[node][k] * at[std::size_t(k)]);
  return weight;
}

double Interpolation::slope(int node, int axis, const std::array<double, 3>& at) const {
  if (is_prism_) {
    const double end = end_of_prism(node);
    return axis < 2 ? rises[node % 3][axis] * 0.5 * (1 + end * at[2])
                    : share_of_triangle(node % 3, at) * 0.5 * end;
  }
  double slope = 0.5 * corners[node][axis];
  for (int k = 0; k < dimension(); ++k) {
    if (k != axis) slope *= 0.5 * (1 + corners[node][k] * at[std::size_t(k)]);
  }
  return slope;
}

CellMatrix Interpolation::gradients(const std::array<double, 3>& at) const {
  CellMatrix gradients(dimension(), node_count());
  for (int node = 0; node < node_count(); ++node) {
    for (int axis = 0; axis < dimension(); ++axis) gradients(axis, node) = slope(node, axis, at);
  }
  return gradients;
}

/// Products of coordinates; for the prism, of its height and the deviation of two triangle weights from their
/// mean.
CellMatrix Interpolation::modes() const {
  CellMatrix modes(node_count(), mode_count());
  for (int node = 0; node < node_count(); ++node) {
    const double* corner = corners[node];
    for (int mode = 0; mode < mode_count(); ++mode) {
      if (is_prism_) {
        modes(node, mode) = end_of_prism(node) * ((node % 3 == mode + 1 ? 1 : 0) - 1. / 3);
      } else {
        modes(node, mode) =
            mode < 3 ? corner[mode] * corner[(mode + 1) % 3] : corner[0] * corner[1] * corner[2];
      }
    }
  }
  return modes;
}

CellMatrix Interpolation::bubble_gradient(int bubble, const std::array<double, 3>& at) const {
  const int axis = is_prism_ ? 2 : bubble;
  CellMatrix gradient = CellMatrix::Zero(dimension(), 1);
  gradient(axis, 0) = -2 * at[std::size_t(axis)];
  return gradient;
}

}  // namespace halfspace
