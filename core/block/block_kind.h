#pragma once

#include <cstdint>

namespace halfspace {

/// The unknowns of a block. The values are those of the C API; `none` marks a free slot.
enum class BlockKind : std::int32_t { none = -1, fixed = 0, prescribed = 1, rigid = 2, affine = 3, mesh = 4 };

}  // namespace halfspace
