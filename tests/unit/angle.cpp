#include "geometry/angle.h"

#include <limits>
#include <numbers>
#include <random>

#include "catch.h"

// Against the C library's functions of long doubles, which are of 64 bits at least: errors in units of the
// last place.

using namespace halfspace;

namespace {

constexpr int samples = 200000;
constexpr double pi = std::numbers::pi;

double units_off(double value, long double exact) {
  const double size = std::abs(double(exact));
  const double unit = std::nextafter(size, HUGE_VAL) - size;
  return double(std::abs(value - exact) / unit);
}

class Numbers {
 public:
  double between(double from, double to) { return from + (to - from) * (double(random_() >> 11) * 0x1p-53); }
  /// A number of either sign, by powers of two as often small as large.
  double of_any_size(int smallest_power, int largest_power) {
    const int power = smallest_power + int(random_() % unsigned(largest_power - smallest_power + 1));
    return std::ldexp(random_() % 2 ? between(1, 2) : between(-2, -1), power);
  }

 private:
  std::mt19937_64 random_{7};
};

}  // namespace

TEST_CASE("sine and cosine are right to the last place or nearly so") {
  Numbers numbers;
  double small = 0, large = 0;
  for (int i = 0; i < samples; ++i) {
    // Doubles near whole quarters of a turn have the smallest sines and cosines.
    const double near_quarters = std::floor(numbers.between(1, 1e6)) * (pi / 2);
    for (const double angle : {numbers.of_any_size(-4, 62), near_quarters, numbers.between(-pi, pi)}) {
      const auto [cosine, sine] = cosine_and_sine_of_large(angle);
      large = std::max({large, units_off(cosine, std::cos((long double)angle)),
                        units_off(sine, std::sin((long double)angle))});
    }
    const double angle = numbers.between(-0.0625, 0.0625);
    const auto [cosine, sine] = cosine_and_sine_of(angle);
    small = std::max({small, units_off(cosine, std::cos((long double)angle)),
                      units_off(sine, std::sin((long double)angle))});
  }
  CHECK(large < 0.8);
  CHECK(small < 1.01);
}

TEST_CASE("the largest angles are reduced exactly") {
  // This of all doubles comes nearest to a multiple of pi/2 (Muller, Elementary Functions); its
  // cosine is known.
  CHECK(units_off(cosine_and_sine_of(0x1.6ac5b262ca1ffp+849).cosine, -4.68716592425462761112e-19L) < 0.8);
  CHECK(std::abs(cosine_and_sine_of(0x1.6ac5b262ca1ffp+849).sine) == 1);
  const auto [cosine, sine] = cosine_and_sine_of(std::numeric_limits<double>::max());
  CHECK(units_off(sine, 0.00496195478918406170L) < 4);  // of 18 digits
  CHECK(units_off(cosine, -0.99998768942655991120L) < 0.8);
}

TEST_CASE("opposite angles have the same cosine and opposite sines, bit for bit") {
  Numbers numbers;
  for (int i = 0; i < samples; ++i) {
    const double angle = numbers.of_any_size(-60, 1000);
    const auto left = cosine_and_sine_of(angle), right = cosine_and_sine_of(-angle);
    if (left.cosine != right.cosine || left.sine != -right.sine) FAIL("at " << angle);
  }
}

TEST_CASE("what is not finite has no sine") {
  for (const double angle : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    CHECK(std::isnan(cosine_and_sine_of(angle).cosine));
    CHECK(std::isnan(cosine_and_sine_of(angle).sine));
  }
}

TEST_CASE("the tangent of angles of friction") {
  Numbers numbers;
  double most = 0;
  for (int i = 0; i < samples; ++i) {
    const double angle = numbers.between(0, pi / 2), small = std::abs(numbers.of_any_size(-300, -1));
    most = std::max({most, units_off(tangent_of(angle), std::tan((long double)angle)),
                     units_off(tangent_of(small), std::tan((long double)small))});
  }
  CHECK(most < 1);
  CHECK(tangent_of(0) == 0);
  CHECK(units_off(tangent_of(std::nextafter(pi / 2, 0)), std::tan((long double)std::nextafter(pi / 2, 0))) <
        1);
}

TEST_CASE("the angle of a vector") {
  Numbers numbers;
  double most = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = numbers.of_any_size(-40, 40), y = numbers.of_any_size(-40, 40);
    most = std::max(most, units_off(angle_at(x, y), std::atan2((long double)y, (long double)x)));
    const auto [cosine, sine] = cosine_and_sine_of(numbers.between(-pi, pi));
    most =
        std::max(most, units_off(angle_at(cosine, sine), std::atan2((long double)sine, (long double)cosine)));
  }
  CHECK(most < 0.6);
  most = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = numbers.of_any_size(-40, 40), y = std::abs(numbers.of_any_size(-40, 40));
    const auto [cosine, sine] = cosine_and_sine_of(numbers.between(0, pi));
    most = std::max(
        {most, units_off(quick_angle_at(x, y), std::atan2((long double)y, (long double)x)),
         units_off(quick_angle_at(cosine, sine), std::atan2((long double)sine, (long double)cosine))});
  }
  CHECK(most < 3);
  for (const double x : {1.0, -1.0, 0.0, -0.0})
    for (const double y : {1.0, -1.0, 0.0, -0.0})
      if (x != 0 || y != 0) {
        CHECK(angle_at(x, y) == std::atan2(y, x));
        CHECK(std::signbit(angle_at(x, y)) == std::signbit(y));
      }
}
