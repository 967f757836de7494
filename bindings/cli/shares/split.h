#pragma once

#include <algorithm>
#include <cstdint>

#include "common/files.h"
#include "model/library.h"

namespace halfspace::cli {

/// Numbers of blocks in the shares of a world.
struct SplitCounts {
  void add(const hs_share_info& share);

  std::int64_t min_own = INT64_MAX, max_own = 0, min_copies = INT64_MAX, max_copies = 0;
};

/// Cuts a world into shares of as many free blocks each, and writes each as a snapshot, share_0.hsw and so
/// on. @throws LibraryError, std::runtime_error
SplitCounts split(const Context& context, hs_world* world, std::int64_t count, OutputDirectory& directory);

}  // namespace halfspace::cli
