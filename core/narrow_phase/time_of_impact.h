#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/sweep.h"

namespace halfspace {

/// When two moving blocks first touch.
template <int D>
struct Impact {
  enum State { never, touching_at_start, touches };
  State state = never;
  /// Share of the interval, 0 to 1: up to it the blocks are apart, with certainty. Their first touch comes
  /// then or, by as much as the gap takes to close, later. 1 for never.
  double time = 1;
  PotentialPair<D> pair;                 // the one of largest gap then; not for never
  Vector<D> normal = Vector<D>::Zero();  // unit, from a to b; not for never
  double gap = 0;                        // of the pair then: below 0 only when touching at the start
  /// Where they touch, from the centroid of a then: the middle of the contact region. Not for never.
  Vector<D> point = Vector<D>::Zero();
};

/// Finds when two blocks first touch that move over an interval. Outlines are in the shapes' frames, with or
/// without a Gauss map. `room` is for both as they are deformed: of component_count() of a and of b doubles.
template <int D>
Impact<D> time_of_impact(const Outline<D>& a, const Sweep<D>& sweep_of_a, const Outline<D>& b,
                         const Sweep<D>& sweep_of_b, double* room);

}  // namespace halfspace
