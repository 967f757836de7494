#pragma once

#include <string>
#include <vector>

namespace halfspace::cli {

/// Rows of numbers, as spreadsheets and other programs write them.
struct NumberTable {
  std::vector<std::string> names;         ///< the fields of the line before the first row, or none
  std::vector<std::vector<double>> rows;  ///< all of the same length
  std::vector<int> lines;                 ///< of the rows, from 1
};

/// Reads numbers between blanks, semicolons or commas; with other separators a comma is a decimal comma.
/// Skips quotes, comments after # and the lines before the first one that begins with a number.
/// @param unit the noun for the numbers in faults, as "heights"  @throws MeshFault
NumberTable read_number_table(const std::string& name, const std::string& content, const std::string& unit);

}  // namespace halfspace::cli
