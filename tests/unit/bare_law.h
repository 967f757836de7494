#pragma once

#include "force/law.h"

namespace halfspace::test {

/// A law without the damping that laws have by default.
inline ContactLaw bare_law() {
  ContactLaw law;
  law.normal_damping = law.shear_damping = 0;
  return law;
}

}  // namespace halfspace::test
