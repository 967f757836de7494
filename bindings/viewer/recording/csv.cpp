#include "recording/csv.h"

#include <algorithm>
#include <charconv>

namespace halfspace::viewer {

Csv::Csv(const std::string& text) {
  std::vector<std::string> row(1);
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '"') {
      if (!is_quoted && !row.back().empty()) row.back() += c;  // a doubled quote
      is_quoted = !is_quoted;
    } else if (is_quoted || (c != ',' && c != '\n')) {
      row.back() += c;
    } else if (c == ',') {
      row.emplace_back();
    } else {
      (names_.empty() ? names_ : rows_.emplace_back()) = std::move(row);
      row.assign(1, {});
    }
  }
}

std::string Csv::text(std::size_t row, const std::string& column) const {
  const auto found = std::find(names_.begin(), names_.end(), column);
  const auto place = static_cast<std::size_t>(found - names_.begin());
  return found != names_.end() && place < rows_[row].size() ? rows_[row][place] : std::string();
}

double Csv::number(std::size_t row, const std::string& column) const {
  const std::string value = text(row, column);
  double result = 0;
  std::from_chars(value.data(), value.data() + value.size(), result);
  return result;
}

}  // namespace halfspace::viewer
