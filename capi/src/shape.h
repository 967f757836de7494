#pragma once

#include "context.h"
#include "geometry/shape.h"
#include "halfspace/shape.h"

struct hs_shape {
  template <class Source>
  hs_shape(hs_context* owner, const Source& source) : context(owner), shape(source, &owner->memory) {}

  hs_context* context;
  halfspace::Shape<2> shape;
};
