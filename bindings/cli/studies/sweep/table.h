#pragma once

#include <map>
#include <string>
#include <vector>

#include "studies/sweep/grid.h"

namespace halfspace::cli {

/// A run that has ended.
struct SweepRow {
  std::string status;                ///< exit code
  std::string seconds;               ///< wall time
  std::vector<std::string> results;  ///< empty texts if there are none
};

/// The runs of a sweep by their number in the grid.
class SweepTable {
 public:
  /// `identity` is the first line of the table, and names the sweep.
  SweepTable(const Grid& grid, std::vector<std::string> result_names, std::string identity);

  bool has(std::size_t number) const { return rows_.contains(number); }
  void add(std::size_t number, SweepRow row);
  std::size_t count() const { return rows_.size(); }
  std::size_t failed_count() const;
  /// As CSV: the number of each run, its parameters, exit status, wall time and results.
  std::string text() const;
  /// Reads the rows of a table of the same sweep. @throws std::runtime_error
  void read(const std::string& csv);
  /// A line over the first parameter for each combination of the others. `result` is one of result_names.
  std::string chart(const std::string& title, const std::string& result) const;

 private:
  std::string columns() const;

  const Grid& grid_;
  const std::vector<std::string> result_names_;
  const std::string identity_;
  std::map<std::size_t, SweepRow> rows_;
};

/// The cells of a row of CSV.
std::vector<std::string> cells_of(const std::string& row);

}  // namespace halfspace::cli
