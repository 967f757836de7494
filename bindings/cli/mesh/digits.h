#pragma once

#include <string_view>

namespace halfspace::cli {

/// The digits by which a text states coordinates. Programs write them with a number of decimals, or with a
/// number of significant digits, and may drop zeros at the end. The words with the largest number of
/// significant digits have all of theirs, and the largest of them tells in either case how fine they are.
class Digits {
 public:
  /// A decimal number, with or without an exponent.
  void add(std::string_view word);
  /// The value of a unit of the last digit of such words; 0 before there is any.
  double last() const;

 private:
  int significant_ = 0;  // from the first digit that is not 0
  int whole_ = 0;        // before the point, of the largest such word; < 0 below 0.1
};

}  // namespace halfspace::cli
