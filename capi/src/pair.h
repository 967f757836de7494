#pragma once

#include "halfspace/pair.h"
#include "narrow_phase/contact.h"

namespace halfspace::capi {

/// What a host may ask of one pair.
struct PairOptions : DetectOptions {
  double margin = 0;        // blocks with no gap above it are in contact
  bool with_region = true;  // else a contact is its pair alone
};

/// Detection settings from a definition's angles and shares, checked.
DetectOptions read_detect_options(double parallel_angle, double vertex_zone);

/// The same from a host's options, which may be NULL.
PairOptions read_options(const hs_pair_options* options);

/// Refuses what is for polygons only.
void require_for(int dimension, const PairOptions& options);

}  // namespace halfspace::capi
