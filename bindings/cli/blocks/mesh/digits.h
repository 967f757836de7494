#pragma once

#include <string_view>

namespace halfspace::cli {

/// The precision of the coordinates in a text. Programs write a fixed number of decimals, or of significant
/// digits, and may drop trailing zeros. The words with the max number of significant digits are complete, and
/// the largest of them gives the precision in either case.
class Digits {
 public:
  /// A decimal number, with or without an exponent.
  void add(std::string_view word);
  /// The unit of the last digit; 0 without any word.
  double last() const;

 private:
  int significant_ = 0;  // from the first digit that is not 0
  int whole_ = 0;        // before the point, of the largest such word; < 0 below 0.1
};

}  // namespace halfspace::cli
