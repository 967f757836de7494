#include "blocks/mesh/digits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halfspace::cli {
namespace {

constexpr std::string_view figures = "0123456789";

int exponent_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  int exponent = 0;
  std::from_chars(word.data(), word.data() + word.size(), exponent);
  return std::clamp(exponent, -1000, 1000);  // beyond any number that counts
}

}  // namespace

void Digits::add(std::string_view word) {
  const std::size_t mark = std::min(word.find_first_of("eEdD"), word.size());
  const int exponent = mark < word.size() ? exponent_of(word.substr(mark + 1)) : 0;
  const std::string_view mantissa = word.substr(0, mark);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return;  // 0 has no significant digit
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const auto count = [](std::string_view part) {
    return static_cast<int>(std::count_if(part.begin(), part.end(),
                                          [](char c) { return figures.find(c) != std::string_view::npos; }));
  };
  const int behind = count(mantissa.substr(point)), significant = count(mantissa.substr(first));
  const int whole = significant - behind + exponent;
  if (significant > significant_) whole_ = whole;
  if (significant == significant_) whole_ = std::max(whole_, whole);
  significant_ = std::max(significant_, significant);
}

double Digits::last() const { return significant_ > 0 ? std::pow(10, whole_ - significant_) : 0; }

}  // namespace halfspace::cli
