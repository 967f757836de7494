#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>

#include "arithmetic.h"
#include "context_handle.h"
#include "halfspace/status.h"

namespace halfspace::capi {

/// Status and text of a refused call. It is thrown inside the guard only.
struct Refusal {
  hs_status status;
  char text[400];
};

/// The formats of printf, which MinGW-w64 would else take for those of Windows.
#ifdef __MINGW32__
#define HALFSPACE_PRINTF gnu_printf
#else
#define HALFSPACE_PRINTF printf
#endif

/// Ends the call with a status and a text that names the argument and its value.
[[noreturn, gnu::format(HALFSPACE_PRINTF, 2, 3)]] inline void refuse(hs_status status, const char* format,
                                                                     ...) {
  Refusal refusal;
  refusal.status = status;
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(refusal.text, sizeof refusal.text, format, arguments);
  va_end(arguments);
  throw refusal;
}

inline void report(hs_context* context, const char* function, const char* text) {
  if (!context) return;
  char line[ErrorText::size];
  std::snprintf(line, sizeof line, "%s: %s", function, text);
  context->last_error.write(line);
}

/// Calls the body and converts exceptions into a status and an error text. Detection of single pairs uses it,
/// as it triggers no traps: setting the floating-point environment stalls the pipeline, which costs a tenth
/// of a pair (bench_pairs_3d, November 2026).
template <class Body>
hs_status guarded_in_arithmetic_of_host(hs_context* context, const char* function, Body&& body) noexcept {
  try {
    return body();
  } catch (const Refusal& refusal) {
    report(context, function, refusal.text);
    return refusal.status;
  } catch (const std::bad_alloc&) {
    report(context, function, hs_status_string(HS_ERROR_OUT_OF_MEMORY));
    return HS_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception& e) {
    report(context, function, e.what());
    return HS_ERROR_INTERNAL;
  } catch (...) {
    report(context, function, hs_status_string(HS_ERROR_INTERNAL));
    return HS_ERROR_INTERNAL;
  }
}

/// The guard of all other functions that can fail: no exception leaves it. The body runs in the default
/// floating-point environment, whatever the host has set.
template <class Body>
hs_status guarded(hs_context* context, const char* function, Body&& body) noexcept {
  const DefaultArithmetic arithmetic;
  return guarded_in_arithmetic_of_host(context, function, body);
}

}  // namespace halfspace::capi
