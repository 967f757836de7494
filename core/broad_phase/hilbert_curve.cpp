#include "broad_phase/hilbert_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/box.h"

namespace halfspace {
namespace {

/// Halvings of the box along each axis: the place on the curve has 63 bits at most.
template <int D>
constexpr int halvings = D == 2 ? 31 : 21;

template <int D>
using Cell = std::array<std::uint32_t, D>;

/// Turns the indices of a cell into the digits of its place on the curve, one bit of each per halving
/// [Skilling 2004]: each half is mirrored, or its axes are exchanged, so that its curve begins where the last
/// one ends.
template <int D>
void turn_into_place(Cell<D>& cell) {
  constexpr std::uint32_t highest = std::uint32_t(1) << (halvings<D> - 1);
  for (std::uint32_t half = highest; half > 1; half >>= 1) {
    const std::uint32_t below = half - 1;
    for (std::uint32_t& index : cell) {
      if (index & half) {
        cell[0] ^= below;
      } else {
        const std::uint32_t exchanged = (cell[0] ^ index) & below;
        cell[0] ^= exchanged;
        index ^= exchanged;
      }
    }
  }
  for (std::size_t k = 1; k < D; ++k) cell[k] ^= cell[k - 1];
  std::uint32_t flipped = 0;
  for (std::uint32_t half = highest; half > 1; half >>= 1) {
    if (cell[D - 1] & half) flipped ^= half - 1;
  }
  for (std::uint32_t& index : cell) index ^= flipped;
}

template <int D>
std::uint64_t place_on_curve(Cell<D> cell) {
  turn_into_place<D>(cell);
  std::uint64_t place = 0;
  for (int bit = halvings<D>; bit-- > 0;) {
    for (const std::uint32_t digits : cell) place = place << 1 | (digits >> bit & 1);
  }
  return place;
}

/// The cell of a point in a cube of this size about all points.
template <int D>
Cell<D> cell_of(const Vector<D>& point, const Vector<D>& lower, double size) {
  constexpr double cells = double(std::uint32_t(1) << halvings<D>);
  Cell<D> cell{};
  if (!(size > 0)) return cell;
  for (std::size_t k = 0; k < D; ++k) {
    const double part = (point[Eigen::Index(k)] - lower[Eigen::Index(k)]) / size;
    cell[k] = std::uint32_t(std::min(part * cells, cells - 1));
  }
  return cell;
}

}  // namespace

template <int D>
void order_along_curve(std::span<const Vector<D>> points, std::span<std::int32_t> order, Memory* memory) {
  Box<D> box;
  for (const Vector<D>& point : points) box.include(point);
  const double size = points.empty() ? 0 : (box.upper - box.lower).maxCoeff();
  Array<std::pair<std::uint64_t, std::int32_t>> places(memory);
  places.reserve(points.size());
  for (const Vector<D>& point : points)
    places.emplace_back(place_on_curve<D>(cell_of(point, box.lower, size)), std::int32_t(places.size()));
  std::sort(places.begin(), places.end());
  std::transform(places.begin(), places.end(), order.begin(), [](const auto& place) { return place.second; });
}

template void order_along_curve<2>(std::span<const Vector<2>>, std::span<std::int32_t>, Memory*);
template void order_along_curve<3>(std::span<const Vector<3>>, std::span<std::int32_t>, Memory*);

}  // namespace halfspace
