#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

struct Range {
  std::int64_t first;
  std::int64_t length;
};

/// Do the ranges fill an array of that length without gaps or overlaps? Then one can be removed and the
/// others moved up. A range may be empty. Sorts them.
inline bool fill_without_gap(Array<Range>& ranges, std::size_t length) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& p, const Range& q) {
    return p.first < q.first || (p.first == q.first && p.length < q.length);
  });
  std::int64_t past = 0;
  for (const Range& range : ranges) {
    if (range.first != past) return false;
    past += range.length;
  }
  return past == std::int64_t(length);
}

}  // namespace halfspace
