#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

/// A part of an array.
struct Range {
  std::int64_t first;
  std::int64_t length;
};

/// True when the ranges lie one beside the other and fill an array of that length: then each can be taken out
/// and the others moved up. Sorts them.
inline bool fill_without_gap(Array<Range>& ranges, std::size_t length) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& p, const Range& q) { return p.first < q.first; });
  std::int64_t past = 0;
  for (const Range& range : ranges) {
    if (range.first != past) return false;
    past += range.length;
  }
  return past == std::int64_t(length);
}

}  // namespace halfspace
