#include "studies/trade/results.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <sstream>
#include <stdexcept>

#include "common/hash.h"
#include "common/text.h"
#include "studies/trade/runs.h"

namespace halfspace::cli {
namespace {

constexpr const char* columns =
    "step,stiffness,cells,law,kind,damping,skin,tolerance,disturbance,end,value,start,cpu_seconds,simulated";
constexpr std::array<const char*, 8> ends = {"whole",       "interrupted", "unstable",      "too fast",
                                             "not at rest", "inverted",    "too few steps", "no angle"};

std::string first_line(const std::string& scene_text) {
  return "# runs of scene " + std::to_string(hash_of(scene_text)) + " by halfspace " + hs_version();
}

template <class T>
std::string or_nothing(const std::optional<T>& value) {
  return value ? shortest(static_cast<double>(*value)) : std::string();
}

std::string row_of(const Result& result) {
  const Setting& s = result.setting;
  const Outcomes& o = result.outcomes;
  std::string row;
  for (const std::string& cell :
       {shortest(s.step), shortest(s.stiffness), shortest(s.cells), or_nothing(s.law), or_nothing(s.kind),
        or_nothing(s.damping), or_nothing(s.skin), or_nothing(s.tolerance), std::to_string(s.disturbance),
        std::string(ends[static_cast<std::size_t>(o.end)]), shortest(o.value), shortest(o.start),
        shortest(o.cpu_seconds), shortest(o.simulated)})
    row += (row.empty() ? "" : ",") + cell;
  return row;
}

/// The cells of a row, in order. @throws std::runtime_error for an invalid cell
class Cells {
 public:
  explicit Cells(const std::string& row) : stream_(row) {}

  std::string text() {
    std::string cell;
    if (!std::getline(stream_, cell, ',')) throw std::runtime_error("too few cells");
    return cell;
  }
  double number(double low, double high) {
    const std::optional<double> value = maybe_number(low, high);
    if (!value) throw std::runtime_error("an empty cell");
    return *value;
  }
  std::optional<double> maybe_number(double low, double high) {
    const std::string cell = text();
    if (cell.empty()) return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool is_whole = error == std::errc() && end == cell.data() + cell.size();
    if (!is_whole || !(value >= low && value <= high)) throw std::runtime_error("not a number: " + cell);
    return value;
  }
  std::optional<int> maybe_one_of(std::span<const int> allowed) {
    const std::optional<double> value = maybe_number(-1e9, 1e9);
    if (!value) return std::nullopt;
    for (const int one : allowed)
      if (*value == one) return one;
    throw std::runtime_error("unknown law or kind: " + shortest(*value));
  }
  void finish() {
    if (stream_.peek() != std::istringstream::traits_type::eof()) throw std::runtime_error("too many cells");
  }

 private:
  std::istringstream stream_;
};

RunEnd end_named(const std::string& name) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (name == ends[i]) return static_cast<RunEnd>(i);
  throw std::runtime_error("unknown end of a run: " + name);
}

Result result_from(const std::string& row) {
  Cells cells(row);
  Result result;
  Setting& s = result.setting;
  Outcomes& o = result.outcomes;
  constexpr double limit = 1e300;
  s.step = cells.number(1e-6, 1);
  s.stiffness = cells.number(1e-6, 1e6);
  s.cells = cells.number(1e-3, 1e3);
  s.law = cells.maybe_one_of(law_kinds);
  s.kind = cells.maybe_one_of(block_kinds);
  s.damping = cells.maybe_number(0, limit);
  s.skin = cells.maybe_number(0, 1);
  s.tolerance = cells.maybe_number(0, 1);
  s.disturbance = static_cast<int>(cells.number(0, 1000));
  o.end = end_named(cells.text());
  o.value = cells.number(-limit, limit);
  o.start = cells.number(-limit, limit);
  o.cpu_seconds = cells.number(0, limit);
  o.simulated = cells.number(0, limit);
  cells.finish();
  return result;
}

}  // namespace

std::string csv_of(const std::vector<Result>& results, const std::string& scene_text) {
  std::string text = first_line(scene_text) + '\n' + columns + '\n';
  for (const Result& result : results) text += row_of(result) + '\n';
  return text;
}

std::vector<Result> results_from(const std::string& csv, const std::string& scene_text) {
  std::istringstream stream(csv);
  std::string line;
  if (!std::getline(stream, line) || line != first_line(scene_text))
    throw std::runtime_error("its runs are of another scene, or by another version");
  std::getline(stream, line);
  if (line != columns) throw std::runtime_error("its columns are not those of a trade");
  std::vector<Result> results;
  for (int number = 3; std::getline(stream, line); ++number) {
    try {
      results.push_back(result_from(line));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  return results;
}

}  // namespace halfspace::cli
