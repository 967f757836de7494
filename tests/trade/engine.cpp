#include "engine.h"

#include <algorithm>
#include <cmath>

namespace halfspace_trade {

double whole_part(double duration, double step) {
  return duration / std::max(1.0, std::ceil(duration / step * (1 - 1e-12)));
}

std::vector<Setting> with_frame_steps(const std::vector<std::string>& ways) {
  std::vector<Setting> all;
  for (const std::string& way : ways)
    for (int halvings = 0; halvings <= 7; ++halvings)
      all.push_back({way, 0, std::ldexp(1.0 / 60, -halvings)});
  return all;
}

}  // namespace halfspace_trade
