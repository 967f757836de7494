#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "simd/two_lanes.h"

namespace halfspace {

// Four doubles in one value, in two variants: one AVX register, or two registers of the x86-64 baseline. Each
// lane rounds like a double, so both variants give the same bits. Code for both is a template of the lane
// type, `Four`, called by with_widest_lanes().
//
// Functions that take or return AVX lanes are always inlined: the calling convention for them depends on the
// target that the caller is compiled for.

using FourLanes = double __attribute__((vector_size(32)));

/// Two registers. Without AVX, compilers would split FourLanes into scalars.
struct TwiceTwoLanes {
  TwoLanes low;
  TwoLanes high;

  double operator[](int lane) const { return lane < 2 ? low[lane] : high[lane - 2]; }
  TwiceTwoLanes operator+(const TwiceTwoLanes& o) const { return {low + o.low, high + o.high}; }
  TwiceTwoLanes operator-(const TwiceTwoLanes& o) const { return {low - o.low, high - o.high}; }
  TwiceTwoLanes operator*(const TwiceTwoLanes& o) const { return {low * o.low, high * o.high}; }
  TwiceTwoLanes operator/(const TwiceTwoLanes& o) const { return {low / o.low, high / o.high}; }
};

template <class Four>
[[gnu::always_inline]] inline Four four_of(double a, double b, double c, double d) {
  if constexpr (std::is_same_v<Four, TwiceTwoLanes>) {
    return {TwoLanes{a, b}, TwoLanes{c, d}};
  } else {
    return Four{a, b, c, d};
  }
}
template <class Four>
[[gnu::always_inline]] inline Four all_four(double value) {
  return four_of<Four>(value, value, value, value);
}
template <class Four>
[[gnu::always_inline]] inline Four load_four(const double* p) {
  Four lanes;
  __builtin_memcpy(&lanes, p, sizeof lanes);
  return lanes;
}
template <class Four>
[[gnu::always_inline]] inline void store_four(double* p, const Four& lanes) {
  __builtin_memcpy(p, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline TwoLanes low_half(const FourLanes& a) { return TwoLanes{a[0], a[1]}; }
[[gnu::always_inline]] inline TwoLanes high_half(const FourLanes& a) { return TwoLanes{a[2], a[3]}; }
inline TwoLanes low_half(const TwiceTwoLanes& a) { return a.low; }
inline TwoLanes high_half(const TwiceTwoLanes& a) { return a.high; }

/// Per lane: a < b ? then : otherwise. Code that serves one number, too, is a template of it or the lanes.
inline double select_less(double a, double b, double then, double otherwise) {
  return a < b ? then : otherwise;
}
inline TwoLanes select_less(TwoLanes a, TwoLanes b, TwoLanes then, TwoLanes otherwise) {
  return a < b ? then : otherwise;
}
[[gnu::always_inline]] inline FourLanes select_less(const FourLanes& a, const FourLanes& b,
                                                    const FourLanes& then, const FourLanes& otherwise) {
  return a < b ? then : otherwise;
}
inline TwiceTwoLanes select_less(const TwiceTwoLanes& a, const TwiceTwoLanes& b, const TwiceTwoLanes& then,
                                 const TwiceTwoLanes& otherwise) {
  return {select_less(a.low, b.low, then.low, otherwise.low),
          select_less(a.high, b.high, then.high, otherwise.high)};
}

/// The smaller value of each lane.
template <class Four>
[[gnu::always_inline]] inline Four min(const Four& a, const Four& b) {
  return select_less(a, b, a, b);
}

/// The larger value of each lane.
template <class Four>
[[gnu::always_inline]] inline Four max(const Four& a, const Four& b) {
  return select_less(b, a, a, b);
}

[[gnu::always_inline]] inline FourLanes abs(const FourLanes& a) {
  using Bits = long long __attribute__((vector_size(32)));
  return FourLanes(Bits(a) & ~Bits(FourLanes{-0.0, -0.0, -0.0, -0.0}));
}
inline TwiceTwoLanes abs(const TwiceTwoLanes& a) { return {abs(a.low), abs(a.high)}; }

/// The lanes with these indices, of both one after the other.
template <int... lanes>
[[gnu::always_inline]] inline FourLanes picked(const FourLanes& a, const FourLanes& b) {
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, lanes...);
#else
  using Indices = long long __attribute__((vector_size(32)));
  return __builtin_shuffle(a, b, Indices{lanes...});
#endif
}

/// Lane k of row i becomes lane i of row k.
[[gnu::always_inline]] inline void transpose(FourLanes (&rows)[4]) {
  const FourLanes even_low = picked<0, 4, 2, 6>(rows[0], rows[1]),
                  odd_low = picked<1, 5, 3, 7>(rows[0], rows[1]),
                  even_high = picked<0, 4, 2, 6>(rows[2], rows[3]),
                  odd_high = picked<1, 5, 3, 7>(rows[2], rows[3]);
  rows[0] = picked<0, 1, 4, 5>(even_low, even_high);
  rows[1] = picked<0, 1, 4, 5>(odd_low, odd_high);
  rows[2] = picked<2, 3, 6, 7>(even_low, even_high);
  rows[3] = picked<2, 3, 6, 7>(odd_low, odd_high);
}
inline void transpose(TwiceTwoLanes (&rows)[4]) {
  const auto [a, b, c, d] = rows;
  rows[0] = {firsts(a.low, b.low), firsts(c.low, d.low)};
  rows[1] = {seconds(a.low, b.low), seconds(c.low, d.low)};
  rows[2] = {firsts(a.high, b.high), firsts(c.high, d.high)};
  rows[3] = {seconds(a.high, b.high), seconds(c.high, d.high)};
}

template <class Four>
[[gnu::always_inline]] inline double reduce(const Four& a) {
  const TwoLanes two = low_half(a) + high_half(a);
  return two[0] + two[1];
}
template <class Four>
[[gnu::always_inline]] inline double reduce_min(const Four& a) {
  const TwoLanes two = min(low_half(a), high_half(a));
  return std::min(two[0], two[1]);
}
template <class Four>
[[gnu::always_inline]] inline double reduce_max(const Four& a) {
  const TwoLanes two = max(low_half(a), high_half(a));
  return std::max(two[0], two[1]);
}

inline double sqrt(double a) { return std::sqrt(a); }
template <class Four>
[[gnu::always_inline]] inline Four sqrt(const Four& a) {
  return four_of<Four>(std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3]));
}

/// Bit i is the sign bit of lane i; it is set for -0 too.
template <class Four>
[[gnu::always_inline]] inline unsigned signs_of_four(const Four& a) {
  return signs(low_half(a)) | signs(high_half(a)) << 2;
}

#ifdef __x86_64__
/// Runs work compiled for AVX2, with all its calls inlined.
template <class Work>
[[gnu::target("avx2"), gnu::flatten]] inline auto with_avx2(const Work& work) {
  return work.template operator()<FourLanes>();
}
#endif

/// Runs work, a function template of the lane type, with the widest lanes of the processor.
template <class Work>
inline auto with_widest_lanes(const Work& work) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return with_avx2(work);
#endif
  return work.template operator()<TwiceTwoLanes>();
}

}  // namespace halfspace
