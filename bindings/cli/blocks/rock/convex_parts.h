#pragma once

#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// Divides a polygon that neither touches nor crosses itself into convex ones, between its corners: triangles
/// by clipping of ears, then merged across their common edges while they stay convex (Hertel and Mehlhorn
/// 1983). There are at most four times as many as necessary. Counter-clockwise. Empty if the polygon is too
/// thin to be divided.
std::vector<std::vector<Point>> convex_parts(std::vector<Point> polygon);

}  // namespace halfspace::cli
