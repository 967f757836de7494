#pragma once

#include "model/layout.h"

namespace halfspace::cli {

/// Finds the blocks at the ends of bolts that stages install, so that no run stops there. An end in a hole,
/// outside of all blocks or where a block is excavated by then, is a fault.
void find_bolt_ends(const Context& context, const Scene& scene, Layout& layout, Faults& faults);

}  // namespace halfspace::cli
