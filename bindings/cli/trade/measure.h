#pragma once

#include <algorithm>

#include "trade/quantity.h"
#include "trade/setting.h"

namespace halfspace::cli {

/// Runs the scene with its knobs turned and takes the quantity; short runs several times, of which the
/// fastest tells the cost. A friction angle is found by halving the interval from 0 to 89 degrees.
/// @throws LibraryError, std::runtime_error
Outcomes measure(const Setting& setting, const Scene& scene, const FaceSize& face);

/// Calls run() again where it took less CPU time than tells much by a clock: the fastest of several runs
/// tells the cost. One that does not come to its end tells none.
template <class Run>
auto fastest_of(double short_run, Run run) {
  constexpr int most_repeats = 5;
  auto fastest = run();
  for (int i = 1; i < most_repeats && fastest.end == RunEnd::whole && fastest.cpu_seconds < short_run; ++i) {
    auto again = run();
    if (again.end != RunEnd::whole) return again;
    fastest.cpu_seconds = std::min(fastest.cpu_seconds, again.cpu_seconds);
  }
  return fastest;
}

/// The width of the last interval in which a friction angle lies, in degrees.
double angle_resolution();

/// The blocks of a scene that has been checked, or of one with its knobs turned. @throws std::runtime_error
Layout layout_of(const Context& context, const Scene& scene);

/// The typical face of the scene's blocks.
FaceSize typical_face(const Scene& scene);
/// See Layout.
bool names_cells(const Scene& scene);

}  // namespace halfspace::cli
