#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The order of points along a Hilbert curve through their box: points that follow each other are close, and
/// close points have close places. Writes the indices of the points; points in one place keep their order.
template <int D>
void order_along_curve(std::span<const Vector<D>> points, std::span<std::int32_t> order, Memory* memory);

extern template void order_along_curve<2>(std::span<const Vector<2>>, std::span<std::int32_t>, Memory*);
extern template void order_along_curve<3>(std::span<const Vector<3>>, std::span<std::int32_t>, Memory*);

}  // namespace halfspace
