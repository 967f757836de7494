#pragma once

#include <cmath>

namespace halfspace {

/// Two doubles in one register of the x86-64 baseline. The vector extensions of GCC and Clang also compare
/// and select per lane. Each lane rounds like a double, so results are the same bits as with scalars.
using TwoLanes = double __attribute__((vector_size(16)));

inline TwoLanes load_two(const double* p) {
  TwoLanes lanes;
  __builtin_memcpy(&lanes, p, sizeof lanes);
  return lanes;
}

inline void store_two(double* p, TwoLanes lanes) { __builtin_memcpy(p, &lanes, sizeof lanes); }

inline TwoLanes both(double value) { return TwoLanes{value, value}; }

/// The first (second) lanes of both.
inline TwoLanes firsts(TwoLanes a, TwoLanes b) { return TwoLanes{a[0], b[0]}; }
inline TwoLanes seconds(TwoLanes a, TwoLanes b) { return TwoLanes{a[1], b[1]}; }

inline TwoLanes exchanged(TwoLanes a) { return TwoLanes{a[1], a[0]}; }

/// The sum of the lanes of each.
inline TwoLanes sums(TwoLanes a, TwoLanes b) { return firsts(a, b) + seconds(a, b); }

/// Bit i is the sign bit of lane i; it is set for -0 too.
inline unsigned signs(TwoLanes a) {
#ifdef __SSE2__
  return unsigned(__builtin_ia32_movmskpd(a));
#else
  return unsigned(std::signbit(a[0])) | unsigned(std::signbit(a[1])) << 1;
#endif
}

inline TwoLanes min(TwoLanes a, TwoLanes b) { return a < b ? a : b; }
inline TwoLanes max(TwoLanes a, TwoLanes b) { return a > b ? a : b; }

inline double abs(double a) { return std::abs(a); }
inline TwoLanes abs(TwoLanes a) {
  using Bits = long long __attribute__((vector_size(16)));
  return TwoLanes(Bits(a) & ~Bits(TwoLanes{-0.0, -0.0}));
}

}  // namespace halfspace
