#pragma once

#include <string>
#include <vector>

namespace halfspace::viewer {

/// A table of comma-separated values with a line of names.
class Csv {
 public:
  explicit Csv(const std::string& text);
  std::size_t row_count() const { return rows_.size(); }
  /// A value, or an empty text where the table has no such column.
  std::string text(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace halfspace::viewer
