#pragma once

#include "context.h"
#include "fingerprint.h"
#include "geometry/shape.h"
#include "halfspace/shape.h"

struct hs_shape {
  template <class Source>
  hs_shape(hs_context* owner, const Source& source) : context(owner), shape(source, &owner->memory) {
    fingerprint = halfspace::capi::fingerprint_of(shape.outline());
  }

  hs_context* context;
  std::uint64_t fingerprint;
  halfspace::Shape<2> shape;
};
