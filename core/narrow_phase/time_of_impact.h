#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/sweep.h"

namespace halfspace {

/// The first touch of two moving blocks.
template <int D>
struct Impact {
  enum State { never, touching_at_start, touches };
  State state = never;
  /// Fraction of the interval, 0 to 1, up to which the blocks are certainly apart. The first touch is then,
  /// or as much later as the gap takes to close. 1 for never.
  double time = 1;
  PotentialPair<D> pair;                 // of largest gap at that time; not for never
  Vector<D> normal = Vector<D>::Zero();  // unit, from a to b; not for never
  double gap = 0;                        // of the pair at that time: below 0 only for touching_at_start
  /// The centre of the contact region, relative to the centroid of a at that time. Not for never.
  Vector<D> point = Vector<D>::Zero();
};

/// Computes the first touch of two blocks that move over an interval. Outlines are in the shapes' frames,
/// with or without a Gauss map. `room` has component_count() of a plus that of b doubles.
template <int D>
Impact<D> time_of_impact(const Outline<D>& a, const Sweep<D>& sweep_of_a, const Outline<D>& b,
                         const Sweep<D>& sweep_of_b, double* room);

}  // namespace halfspace
