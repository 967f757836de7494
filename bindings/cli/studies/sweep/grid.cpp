#include "studies/sweep/grid.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "common/text.h"

namespace halfspace::cli {
namespace {

constexpr std::size_t max_runs = 10'000;
constexpr std::int64_t max_digits = 1'000'000'000'000'000;  // sums of such numbers do not overflow

/// The number digits * 10^exponent.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

/// Empty if the text is no decimal number, or one with more than 15 digits.
std::optional<Decimal> decimal_of(std::string_view text) {
  Decimal decimal;
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  std::string digits(text.substr(0, mark));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    decimal.exponent = -static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const auto read = [](std::string_view number, auto& value) {
    if (number.starts_with('+')) number.remove_prefix(1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    return error == std::errc() && end == number.data() + number.size();
  };
  int exponent = 0;
  if (!read(digits, decimal.digits) || std::abs(decimal.digits) >= max_digits) return std::nullopt;
  if (mark < text.size() && (!read(text.substr(mark + 1), exponent) || std::abs(exponent) > 300))
    return std::nullopt;
  decimal.exponent += exponent;
  return decimal;
}

/// The same number with a lower exponent; empty if it has too many digits.
std::optional<std::int64_t> digits_at(Decimal decimal, int exponent) {
  for (; decimal.digits != 0 && decimal.exponent > exponent; --decimal.exponent) {
    decimal.digits *= 10;
    if (std::abs(decimal.digits) >= max_digits) return std::nullopt;
  }
  return decimal.digits;
}

/// A whole number without a point, so that keys of whole numbers take it.
std::string text_of(std::int64_t digits, int exponent) {
  if (exponent == 0) return std::to_string(digits);
  const std::string text = std::to_string(digits) + 'e' + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return shortest(value);
}

/// The three parts of first:last:step; empty if the text is no range.
std::optional<std::vector<std::string>> parts_of_range(const std::string& text) {
  if (text.find_first_of("\"'[{") != std::string::npos) return std::nullopt;
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts.size() == 1 ? std::nullopt : std::optional(parts);
}

[[noreturn]] void refuse_range(const std::string& text, const std::string& fault) {
  throw std::invalid_argument(text + ": " + fault + "; allowed: first:last:step, as 15:40:5");
}

void add_range(const std::string& text, const std::vector<std::string>& parts,
               std::vector<std::string>& values) {
  if (parts.size() != 3) refuse_range(text, "not a range");
  std::vector<Decimal> numbers;
  for (const std::string& part : parts) {
    const std::optional<Decimal> number = decimal_of(part);
    if (!number) refuse_range(text, "not a number of up to 15 digits: " + part);
    numbers.push_back(*number);
  }
  const int exponent = std::min({numbers[0].exponent, numbers[1].exponent, numbers[2].exponent, 0});
  std::vector<std::int64_t> digits;
  for (const Decimal& number : numbers) {
    const std::optional<std::int64_t> aligned = digits_at(number, exponent);
    if (!aligned) refuse_range(text, "more than 15 digits");
    digits.push_back(*aligned);
  }
  if (digits[2] == 0 || (digits[1] - digits[0]) / digits[2] < 0 ||
      (digits[1] != digits[0] && (digits[1] > digits[0]) != (digits[2] > 0)))
    refuse_range(text, "the step never reaches the end");
  const std::int64_t steps = (digits[1] - digits[0]) / digits[2];
  if (steps >= static_cast<std::int64_t>(max_runs))
    refuse_range(text, "more than " + std::to_string(max_runs) + " values");
  for (std::int64_t i = 0; i <= steps; ++i) values.push_back(text_of(digits[0] + i * digits[2], exponent));
}

/// The texts between commas outside of brackets and quotes.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

}  // namespace

std::vector<std::string> values_from(const std::string& text) {
  std::vector<std::string> values;
  for (const std::string& part : split(text)) {
    if (const auto range = parts_of_range(part)) {
      add_range(part, *range, values);
    } else {
      values.push_back(part);
    }
  }
  return values;
}

std::size_t Grid::count() const {
  std::size_t count = 1;
  for (const Axis& axis : axes) count *= axis.values.size();
  return count;
}

std::vector<std::string> Grid::values_of(std::size_t number) const {
  std::vector<std::string> values(axes.size());
  for (std::size_t i = axes.size(); i-- > 0; number /= axes[i].values.size())
    values[i] = axes[i].values[number % axes[i].values.size()];
  return values;
}

std::vector<std::string> Grid::settings_of(std::size_t number) const {
  std::vector<std::string> settings = fixed;
  const std::vector<std::string> values = values_of(number);
  for (std::size_t i = 0; i < axes.size(); ++i) settings.push_back(axes[i].key + '=' + values[i]);
  return settings;
}

Grid grid_of(const std::vector<std::string>& settings) {
  Grid grid;
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::vector<std::string> values = values_from(setting.substr(std::min(equals + 1, setting.size())));
    if (values.size() == 1) {
      grid.fixed.push_back(setting);
    } else {
      grid.axes.push_back({setting.substr(0, equals), values});
    }
    if (grid.count() > max_runs)
      throw std::invalid_argument("more than " + std::to_string(max_runs) + " runs");
  }
  if (grid.axes.empty())
    throw std::invalid_argument("nothing to vary; required: --set KEY=FIRST:LAST:STEP or --set KEY=A,B,C");
  return grid;
}

}  // namespace halfspace::cli
