#pragma once

#include <cstdint>

#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// The maximum number of edges of a block for an EdgeSet.
constexpr int max_edges_in_set = 64;

/// Tests the edge-edge potential contact pairs of two blocks in one orientation, each of up to
/// max_edges_in_set edges (Wang et al. 2021, eqs. 23-30). If their largest gap exceeds that of `best`, it
/// replaces `best`.
void judge_edge_pairs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, Separation<3>& best);

}  // namespace halfspace
