#pragma once

// What holds of every contact whatever the blocks, in the manner of MuJoCo's contact fuzz test: against
// distances found by brute force in long double, independent of half-spaces.

#include "extremes/scenes.h"

namespace halfspace_test {

/// Of any contact, with a cache or without: unit normal, counts, each point within its own gap of both
/// blocks.
void check_invariants(const Scene& scene, const hs_contact& contact);

/// Of a contact found without a cache: not deeper than the least depth.
void check_least_depth(const Scene& scene, const hs_contact& contact);

/// Distance of two blocks that do not overlap, vertex by vertex.
long double distance(const Scene& scene);

}  // namespace halfspace_test
