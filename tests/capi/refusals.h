#pragma once

// Tables of calls that must be refused: a status, and a text that names the function, the argument and its
// value.

#include <functional>
#include <string>
#include <vector>

#include "capi/handles.h"
#include "catch.h"

namespace halfspace_test {

/// A value that a refused call must leave alone.
inline hs_shape* const no_shape = reinterpret_cast<hs_shape*>(0x10);

struct Refusal {
  std::string argument;
  std::string value;
  std::function<hs_status()> call;
  hs_status status = HS_ERROR_ARGUMENT;
};

inline void check_refusals(hs_context* context, const std::string& function,
                           const std::vector<Refusal>& refusals) {
  for (const Refusal& r : refusals) {
    // So that a text left over from the case before is not taken for this one's.
    (void)hs_polygon_check(context, {}, nullptr);
    INFO(function << ", " << r.argument << " = " << r.value);
    CHECK(r.call() == r.status);
    const std::string text = hs_context_last_error(context);
    INFO("the text is: " << text);
    CHECK(text.find(function) == 0);
    CHECK(text.find(r.argument) != std::string::npos);
    CHECK(text.find(r.value) != std::string::npos);
  }
}

}  // namespace halfspace_test
