#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace halfspace::capi {

/// As long as it lives the processor computes as it does by default: rounds to nearest, keeps numbers near 0,
/// and lets what is not a number pass. Hosts may have it otherwise, as Fortran programs that end at the first
/// invalid operation; but lanes that a mask takes out later hold such numbers, compilers work ahead of
/// comparisons, and results shall have the same bits in every host. In the end all is as the host had it,
/// flags of exceptions among it.
class DefaultArithmetic {
 public:
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

#ifdef __SSE2__
  // All that the library computes is in the registers that this word controls. It costs little to look at.
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
