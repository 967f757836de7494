#pragma once

#include "halfspace/pair.h"
#include "narrow_phase/posed_pair.h"
#include "pose_and_vector.h"
#include "shape_handle.h"

namespace halfspace::capi {

/// Both shapes have dimension D.
template <int D>
PosedPair<D> posed_as(const hs_shape& a, const hs_pose& at_a, const hs_shape& b, const hs_pose& at_b) {
  return {as<D>(a), given(at_a), as<D>(b), given(at_b)};
}

/// Calls use(posed) with the PosedPair<2> or PosedPair<3> of two shapes of the same dimension.
template <class Use>
auto visit(const hs_shape& a, const hs_pose& at_a, const hs_shape& b, const hs_pose& at_b, Use&& use) {
  return a.dimension() == 2 ? use(posed_as<2>(a, at_a, b, at_b)) : use(posed_as<3>(a, at_a, b, at_b));
}

inline void require_one_dimension(const hs_shape& a, const ArgumentName& name_a, const hs_shape& b,
                                  const ArgumentName& name_b) {
  if (a.dimension() != b.dimension()) {
    refuse(HS_ERROR_ARGUMENT, "%s has dimension %d and %s %d; they must be equal",
           NameText(name_a).characters, a.dimension(), NameText(name_b).characters, b.dimension());
  }
}

/// Returns validated detection settings.
DetectOptions read_detect_options(double parallel_angle, double vertex_zone);

/// Returns validated options; NULL returns the defaults.
PairOptions read_options(const hs_pair_options* options);

/// Refuses options that are for polygons only, in 3D.
void require_for(int dimension, const PairOptions& options);

}  // namespace halfspace::capi
