#pragma once

#include <algorithm>

#include "studies/trade/quantity.h"
#include "studies/trade/setting.h"

namespace halfspace::cli {

/// Runs the scene with a setting and measures its quantity. Short runs are repeated, and the fastest gives
/// the cost. A friction angle is found by bisection between 0 and 89 degrees. @throws LibraryError,
/// std::runtime_error
Outcomes measure(const Setting& setting, const Scene& scene, const FaceSize& face);

/// Repeats runs below `short_run` seconds of CPU time, whose timing is inaccurate; the fastest gives the
/// cost. A run that does not reach its end is returned at once.
template <class Run>
auto fastest_of(double short_run, Run run) {
  constexpr int max_runs = 5;
  auto fastest = run();
  for (int i = 1; i < max_runs && fastest.end == RunEnd::whole && fastest.cpu_seconds < short_run; ++i) {
    auto again = run();
    if (again.end != RunEnd::whole) return again;
    fastest.cpu_seconds = std::min(fastest.cpu_seconds, again.cpu_seconds);
  }
  return fastest;
}

/// The final width of the bisection of a friction angle, degrees.
double angle_resolution();

/// The blocks of a checked scene, or of one with a setting. @throws std::runtime_error
Layout layout_of(const Context& context, const Scene& scene);

/// The typical face of the scene's blocks.
FaceSize typical_face(const Scene& scene);
/// See Layout.
bool names_cells(const Scene& scene);

}  // namespace halfspace::cli
