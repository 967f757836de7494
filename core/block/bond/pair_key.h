#pragma once

#include <algorithm>
#include <cstdint>

namespace halfspace {

/// One key for two blocks in either order.
inline std::uint64_t pair_key(std::int32_t a, std::int32_t b) {
  return (std::uint64_t(std::uint32_t(std::min(a, b))) << 32) | std::uint32_t(std::max(a, b));
}

}  // namespace halfspace
