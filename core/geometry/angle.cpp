#include "geometry/angle.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "geometry/precise.h"

// The angle is reduced to quarter turns exactly: its 53 bits times the relevant bits of 2/pi (Payne and Hanek
// 1983). The remainder, at most half a quarter turn, is the argument of short series of sine and cosine. The
// angle of a vector is reduced by the nearest of nine directions, and the remainder is the argument of a
// short series of the arctangent. The rounding error of a series' leading term is added in.

namespace halfspace {
namespace {

constexpr Precise quarter_turn = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// 2/pi in binary, after 64 zero bits.
constexpr std::uint32_t quarters_per_radian[] = {
    0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599,
    0x3c439041, 0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c,
    0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639,
    0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f,
    0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7,
    0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d};

/// 32 bits, from a bit counted from the first zero.
std::uint32_t bits_from(int place) {
  const std::uint64_t two_words =
      std::uint64_t(quarters_per_radian[place / 32]) << 32 | quarters_per_radian[place / 32 + 1];
  return std::uint32_t(two_words >> (32 - place % 32));
}

Precise sum(double larger, double smaller) {
  const double s = larger + smaller;
  return {s, smaller - (s - larger)};
}

Precise operator/(const Precise& a, const Precise& b) {
  const double quotient = a.high / b.high;
  const double rest = std::fma(-quotient, b.high, a.high) + (a.low - quotient * b.low);
  return {quotient, rest / b.high};
}

/// An angle as a number of quarter turns modulo 4, and a remainder in radians.
struct Quarters {
  unsigned whole;
  Precise rest;
};

/// Requires an angle above 1e-15.
Quarters quarters_of(double angle) {
  int exponent;
  const auto digits = std::uint64_t(std::ldexp(std::frexp(angle, &exponent), 53));
  exponent -= 53;
  // Bits above these 192 are whole turns, bits below are negligible.
  constexpr int words = 6;
  std::array<std::uint32_t, words>
      product{};  // lowest word first; 2 bits of whole quarters, then the remainder
  for (const int half : {0, 1}) {
    std::uint64_t carry = 0;
    for (int i = half; i < words; ++i) {
      const std::uint64_t digit = std::uint32_t(digits >> 32 * half);
      carry += digit * bits_from(62 + exponent + 32 * (words - 1 - i + half)) + product[std::size_t(i)];
      product[std::size_t(i)] = std::uint32_t(carry);
      carry >>= 32;
    }
  }
  const auto bits_after = [&](std::size_t i) { return product[i] << 2 | product[i - 1] >> 30; };
  // The remainder is between -1/2 and 1/2 of a quarter turn.
  const std::uint32_t first = bits_after(5);
  const unsigned rounded_up = first >> 31;
  const double a = (double(first) - (rounded_up ? 0x1p32 : 0)) * 0x1p-32, b = bits_after(4) * 0x1p-64,
               c = bits_after(3) * 0x1p-96, d = bits_after(2) * 0x1p-128;
  const Precise ab = sum(a, b);
  const Precise all = sum(ab.high, ab.low + (c + d));
  return {(product[5] >> 30) + rounded_up, all * quarter_turn};
}

/// Requires a remainder of at most pi/4 in magnitude.
Precise cosine_of_rest(const Precise& r) {
  const double q = r.high * r.high, lost = std::fma(r.high, r.high, -q);
  constexpr double c4 = 1 / 24.0, c6 = 1 / 720.0, c8 = 1 / 40320.0, c10 = 1 / 3628800.0,
                   c12 = 1 / 479001600.0, c14 = 1 / 87178291200.0, c16 = 1 / 20922789888000.0;
  const double further = q * q * (c4 - q * (c6 - q * (c8 - q * (c10 - q * (c12 - q * (c14 - q * c16))))));
  const Precise first = sum(1, -0.5 * q);
  return sum(first.high, first.low + (further - (0.5 * lost + r.high * r.low)));
}

Precise sine_of_rest(const Precise& r) {
  const double q = r.high * r.high;
  constexpr double s3 = 1 / 6.0, s5 = 1 / 120.0, s7 = 1 / 5040.0, s9 = 1 / 362880.0, s11 = 1 / 39916800.0,
                   s13 = 1 / 6227020800.0, s15 = 1 / 1307674368000.0, s17 = 1 / 355687428096000.0;
  const double further =
      q * (s3 - q * (s5 - q * (s7 - q * (s9 - q * (s11 - q * (s13 - q * (s15 - q * s17)))))));
  return sum(r.high, r.low * (1 - 0.5 * q) - r.high * further);
}

double rounded(const Precise& a) { return a.high + a.low; }
Precise operator-(const Precise& a) { return {-a.high, -a.low}; }

CosineAndSine<Precise> precise_cosine_and_sine(double angle) {
  const double magnitude = std::abs(angle);
  const Quarters quarters = magnitude < 0.5 ? Quarters{0, {magnitude, 0}} : quarters_of(magnitude);
  const Precise c = cosine_of_rest(quarters.rest), s = sine_of_rest(quarters.rest);
  const CosineAndSine<Precise> turned[] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
  const CosineAndSine<Precise>& of_magnitude = turned[quarters.whole % 4];
  return {of_magnitude.cosine, std::signbit(angle) ? -of_magnitude.sine : of_magnitude.sine};
}

/// Arctangents of 0/8 to 8/8.
constexpr Precise angle_of_eighths[] = {{0, 0},
                                        {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                        {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                        {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                        {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                        {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                        {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                        {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                        {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

/// The nearest eighth of a slope rise / run from 0 to 1; 0 of any other, such as NaN.
int eighths_of_slope(double rise, double run) {
  const double ratio = 8 * rise / run;
  return ratio >= 0 && ratio <= 8 ? int(ratio + 0.5) : 0;
}

/// The difference of an angle up to 1/16 rad from its tangent.
double bend(double t) {
  const double q = t * t;
  constexpr double t3 = 1 / 3.0, t5 = 1 / 5.0, t7 = 1 / 7.0, t9 = 1 / 9.0, t11 = 1 / 11.0, t13 = 1 / 13.0;
  return t * q * (t3 - q * (t5 - q * (t7 - q * (t9 - q * (t11 - q * t13)))));
}

/// Requires a slope rise / run from 0 to 1. The angle of any other, such as NaN, means nothing.
Precise angle_of_slope(double rise, double run) {
  const int eighths = eighths_of_slope(rise, run);
  const Precise slope = {eighths / 8.0, 0}, negative_slope = {-eighths / 8.0, 0};
  const Precise further =
      (Precise{rise, 0} - slope * Precise{run, 0}) / (Precise{run, 0} - negative_slope * Precise{rise, 0});
  const double t = further.high;
  const Precise& first = angle_of_eighths[eighths];
  const Precise both = eighths ? sum(first.high, t) : Precise{t, 0};
  return {both.high, both.low + (first.low + (further.low - bend(t)))};
}

}  // namespace

CosineAndSine<double> cosine_and_sine_of_large(double angle) {
  if (!std::isfinite(angle)) return {angle - angle, angle - angle};
  const auto [cosine, sine] = precise_cosine_and_sine(angle);
  return {rounded(cosine), rounded(sine)};
}

double tangent_of(double angle) {
  const auto [cosine, sine] = precise_cosine_and_sine(angle);
  return rounded(sine / cosine);
}

double angle_at(double x, double y) {
  const double run = std::abs(x), rise = std::abs(y);
  Precise angle = angle_of_slope(std::min(run, rise), std::max(run, rise));
  if (rise > run) angle = quarter_turn - angle;
  if (std::signbit(x)) angle = Precise{2 * quarter_turn.high, 2 * quarter_turn.low} - angle;
  return std::copysign(rounded(angle), y);
}

double quick_angle_at(double x, double y) {
  const double width = std::abs(x), run = std::max(width, y), rise = std::min(width, y);
  const int eighths = eighths_of_slope(rise, run);
  const double slope = eighths / 8.0, t = (rise - slope * run) / (run + slope * rise);
  double angle = angle_of_eighths[eighths].high + (t - bend(t));
  if (y > width) angle = quarter_turn.high - angle;
  return x < 0 ? 2 * quarter_turn.high - angle : angle;
}

}  // namespace halfspace
