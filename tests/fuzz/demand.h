#pragma once

// How a target fails: a line that says what does not hold, and abort(), which fuzzers and tests see.

#include <halfspace/halfspace.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace halfspace_fuzz {

/// Demands that must be met whatever the bytes are.
inline void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// A call ends with HS_OK or one of these.
inline bool succeeds_or(hs_status status, std::initializer_list<hs_status> allowed, const char* call) {
  bool known = status == HS_OK;
  for (const hs_status one : allowed) known = known || status == one;
  if (!known) std::fprintf(stderr, "%s: %s\n", call, hs_status_string(status));
  demand(known, "the call ends with a status that its comment names");
  return status == HS_OK;
}

}  // namespace halfspace_fuzz
