#pragma once

// The bytes of a fuzzer as numbers: most of them tame, so that shapes arise and meet, and some of those that
// lead programs astray.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>

namespace halfspace_fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  bool empty() const { return left_ == 0; }

  /// 0 where no byte is left.
  std::uint8_t byte() {
    if (empty()) return 0;
    --left_;
    return *next_++;
  }

  /// At least 0, below `end`, which is at most 256.
  int below(int end) { return byte() % end; }
  int between(int first, int last) { return first + below(last - first + 1); }
  bool flag() { return byte() & 1; }

  template <class T>
  T raw() {
    T value{};
    const std::size_t count = std::min(left_, sizeof value);
    if (count > 0) std::memcpy(&value, next_, count);
    next_ += count;
    left_ -= count;
    return value;
  }

  /// Any double; nearly all are multiples of 1/256 below 128 in size.
  double number() {
    const int form = byte();
    if (form < 216) return last_ = raw<std::int16_t>() / 256.0;
    if (form < 228) return last_ = std::nextafter(last_, flag() ? HUGE_VAL : -HUGE_VAL);
    if (form < 236) return last_ = -last_;
    if (form < 244) return last_ = std::ldexp(raw<std::int16_t>() / 256.0, raw<std::int8_t>());
    if (form < 250) return astray();
    return raw<double>();
  }

  /// A number of at least 0 unless it is one of those that lead astray: 2^-16 to 2^15.
  double positive() {
    const int form = byte();
    return form < 240 ? std::ldexp(1 + form / 240.0, between(-16, 15)) : number();
  }

  /// The default of a definition where the bytes say so.
  double positive_or(double otherwise) { return flag() ? positive() : otherwise; }

  std::string rest() {
    std::string text(reinterpret_cast<const char*>(next_), left_);
    left_ = 0;
    return text;
  }

 private:
  double astray() {
    static constexpr double numbers[] = {0.0,
                                         -0.0,
                                         1 + 0x1p-52,
                                         1 - 0x1p-53,
                                         5e-324,
                                         1e-310,
                                         std::numeric_limits<double>::min(),
                                         1e-75,
                                         1e-51,
                                         1e-16,
                                         1e16,
                                         1e50,
                                         1e75,
                                         -1e75,
                                         1e76,
                                         1e154,
                                         1e300,
                                         std::numeric_limits<double>::max(),
                                         HUGE_VAL,
                                         -HUGE_VAL,
                                         std::numeric_limits<double>::quiet_NaN()};
    return numbers[std::size_t(below(std::size(numbers)))];
  }

  const std::uint8_t* next_;
  std::size_t left_;
  double last_ = 1;
};

}  // namespace halfspace_fuzz
