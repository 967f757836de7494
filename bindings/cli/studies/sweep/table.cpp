#include "studies/sweep/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/text.h"
#include "output/picture/line_chart.h"

namespace halfspace::cli {
namespace {

/// NaN for a text that is no number.
double value_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && !text.empty();
  return is_number ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '"') {
      if (is_quoted && i + 1 < row.size() && row[i + 1] == '"') {
        cells.back() += row[i++];
      } else {
        is_quoted = !is_quoted;
      }
    } else if (row[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  return cells;
}

SweepTable::SweepTable(const Grid& grid, std::vector<std::string> result_names, std::string identity)
    : grid_(grid), result_names_(std::move(result_names)), identity_(std::move(identity)) {}

void SweepTable::add(std::size_t number, SweepRow row) {
  row.results.resize(result_names_.size());
  rows_[number] = std::move(row);
}

std::size_t SweepTable::failed_count() const {
  return static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const auto& row) { return row.second.status != "0"; }));
}

std::string SweepTable::columns() const {
  std::string text = "run";
  for (const Axis& axis : grid_.axes) text += ',' + csv_value(axis.key);
  text += ",exit_status,wall_time";
  for (const std::string& name : result_names_) text += ',' + name;
  return text;
}

std::string SweepTable::text() const {
  std::string text = identity_ + '\n' + columns() + '\n';
  for (const auto& [number, row] : rows_) {
    text += std::to_string(number);
    for (const std::string& value : grid_.values_of(number)) text += ',' + csv_value(value);
    text += ',' + row.status + ',' + row.seconds;
    for (const std::string& result : row.results) text += ',' + result;
    text += '\n';
  }
  return text;
}

void SweepTable::read(const std::string& csv) {
  std::istringstream stream(csv);
  std::string line;
  if (!std::getline(stream, line) || line != identity_)
    throw std::runtime_error(
        "its runs are of another scene, of other values of --set, or by another version");
  if (!std::getline(stream, line) || line != columns())
    throw std::runtime_error("its columns are not those of this sweep");
  const std::size_t parameters = grid_.axes.size();
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    const double number = cells.size() == parameters + result_names_.size() + 3 ? value_in(cells[0]) : -1;
    if (!(number >= 0 && number < static_cast<double>(grid_.count())))
      throw std::runtime_error("not a row of this sweep: " + line);
    const auto results = cells.begin() + static_cast<std::ptrdiff_t>(parameters) + 3;
    add(static_cast<std::size_t>(number),
        {cells[parameters + 1], cells[parameters + 2], {results, cells.end()}});
  }
}

std::string SweepTable::chart(const std::string& title, const std::string& result) const {
  const auto column = static_cast<std::size_t>(std::find(result_names_.begin(), result_names_.end(), result) -
                                               result_names_.begin());
  const Axis& along = grid_.axes.front();
  LineChart chart{
      .title = title, .x_label = along.key, .y_label = result, .line_label = {}, .x_names = {}, .lines = {}};
  const bool has_numbers = std::all_of(along.values.begin(), along.values.end(),
                                       [](const std::string& text) { return std::isfinite(value_in(text)); });
  if (!has_numbers) chart.x_names = along.values;
  for (std::size_t i = 1; i < grid_.axes.size(); ++i)
    chart.line_label += (i == 1 ? "" : ", ") + grid_.axes[i].key;
  // The other parameters vary faster than the first.
  const std::size_t line_count = grid_.count() / along.values.size();
  for (std::size_t line = 0; line < line_count; ++line) {
    std::vector<std::string> others = grid_.values_of(line);
    others.erase(others.begin());
    chart.lines.push_back({joined(others), {}});
    for (std::size_t i = 0; i < along.values.size(); ++i) {
      const auto row = rows_.find(i * line_count + line);
      chart.lines.back().points.push_back({has_numbers ? value_in(along.values[i]) : static_cast<double>(i),
                                           row == rows_.end() ? std::numeric_limits<double>::quiet_NaN()
                                                              : value_in(row->second.results[column])});
    }
  }
  return line_chart(chart);
}

}  // namespace halfspace::cli
