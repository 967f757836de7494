#include "studies/trade/convergence.h"

#include <cmath>

namespace halfspace::cli {

Convergence convergence_of(const std::vector<double>& values, double rounding) {
  Convergence result;
  if (values.empty()) return result;
  const std::size_t last = values.size() - 1;
  result.limit = values[last];
  if (last < 2) return result;
  result.is_known = true;
  const double change = values[last] - values[last - 1], before = values[last - 1] - values[last - 2];
  result.last_change = std::abs(change);
  if (std::abs(change) <= rounding) {
    result.converges = true;
    return result;
  }
  result.converges = std::abs(change) < std::abs(before);
  if (!result.converges) return result;
  result.order = std::log2(std::abs(before) / std::abs(change));
  // No extrapolation from changes that alternate in sign, or hardly decrease.
  if (change * before > 0 && result.order > 0.5) result.limit += change / (std::exp2(result.order) - 1);
  return result;
}

}  // namespace halfspace::cli
