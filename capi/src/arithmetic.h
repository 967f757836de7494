#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace halfspace::capi {

/// Sets the default floating-point environment during its lifetime: round to nearest, subnormal numbers, no
/// traps. The destructor restores the host's environment, including exception flags. Hosts may enable traps,
/// as Fortran programs do; but masked lanes may hold NaN, compilers evaluate speculatively, and results must
/// be bit-identical in every host.
class DefaultArithmetic {
 public:
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

#ifdef __SSE2__
  // This register controls all arithmetic of the library. Reading it is cheap.
  DefaultArithmetic() : of_host_(_mm_getcsr()) {
    if ((of_host_ & ~unsigned(_MM_EXCEPT_MASK)) != all_traps_off) _mm_setcsr(all_traps_off);
  }
  ~DefaultArithmetic() {
    if (_mm_getcsr() != of_host_) _mm_setcsr(of_host_);
  }

 private:
  static constexpr unsigned all_traps_off = _MM_MASK_MASK;
  unsigned of_host_;
#else
  DefaultArithmetic() {
    std::fegetenv(&of_host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultArithmetic() { std::fesetenv(&of_host_); }

 private:
  std::fenv_t of_host_;
#endif
};

}  // namespace halfspace::capi
