#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/number_table.h"
#include "blocks/mesh/text_lines.h"
#include "blocks/terrain/height_map.h"
#include "common/text.h"

namespace halfspace::cli {
namespace {

constexpr double no_data = std::numeric_limits<double>::quiet_NaN();

/// Coordinates and spacings are written with few digits: within this fraction of a spacing they are those of
/// a grid.
constexpr double rounding = 0.05;

/// The value that grids have at nodes without data, if their header gives none.
constexpr double usual_no_data = -9999;

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Evenly spaced coordinates, some of which occur in a list.
struct Axis {
  double begin = 0;
  double spacing = 0;
  std::size_t count = 0;

  /// The index of a coordinate; empty if it is between two of them.
  std::optional<std::size_t> index(double coordinate) const {
    const double place = (coordinate - begin) / spacing, nearest = std::round(place);
    if (!(std::abs(place - nearest) <= rounding)) return std::nullopt;
    return static_cast<std::size_t>(nearest);
  }
};

/// The axis through the coordinates of a column; without a count if they are not evenly spaced.
Axis axis_of(const NumberTable& table, std::size_t column) {
  std::vector<double> values;
  for (const std::vector<double>& row : table.rows) values.push_back(row[column]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() < 2) return {};
  Axis axis{values.front(), (values.back() - values.front()) / static_cast<double>(values.size() - 1),
            values.size()};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (axis.index(values[i]) != i) return {};
  return axis;
}

/// True for a table whose names say that it lists x, y and height, or easting and northing.
bool names_coordinates(const std::string& name, const NumberTable& table) {
  const auto has = [&](char letter) {
    return std::any_of(table.names.begin(), table.names.end(),
                       [&](const std::string& text) { return lower(text).starts_with(letter); });
  };
  if (!(has('x') && has('y')) && !(has('e') && has('n'))) return false;
  const char first = lower(table.names[0])[0];
  if (table.names.size() == 3 && (first == 'x' || first == 'e')) return true;
  throw MeshFault(name, "columns " + joined(table.names) + "; allowed: x, y and height");
}

/// The grid of a list of x, y and height. Without names a table of three columns is such a list if its rows
/// are more than half of the nodes of a grid.
std::optional<HeightMap> map_of_list(const std::string& name, const NumberTable& table) {
  const bool is_named = names_coordinates(name, table);
  if (table.rows.empty() || table.rows.front().size() != 3) return std::nullopt;
  const Axis x = axis_of(table, 0), y = axis_of(table, 1);
  const bool is_square = std::abs(x.spacing - y.spacing) <= rounding * x.spacing;
  if (x.count == 0 || y.count == 0 || !is_square) {
    if (!is_named) return std::nullopt;
    throw MeshFault(name,
                    "a list of x, y and height whose points are no grid; allowed: x and y with one spacing");
  }
  if (!is_named && 2 * table.rows.size() <= x.count * y.count) return std::nullopt;
  HeightMap map{.columns = x.count,
                .rows = y.count,
                .heights = std::vector<double>(x.count * y.count, no_data),
                .spacing = x.spacing,
                .south_west = {x.begin, y.begin}};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<double>& row = table.rows[i];
    double& height = map.heights[(y.count - 1 - *y.index(row[1])) * x.count + *x.index(row[0])];
    if (!std::isnan(height)) {
      if (!is_named) return std::nullopt;
      throw MeshFault(name + ':' + std::to_string(table.lines[i]),
                      "a second height at [" + shortest(row[0]) + ", " + shortest(row[1]) + ']');
    }
    height = row[2];
  }
  return map;
}

HeightMap map_of_grid(const NumberTable& table) {
  HeightMap map{.columns = table.rows.empty() ? 0 : table.rows.front().size(), .rows = table.rows.size()};
  for (const std::vector<double>& row : table.rows)
    map.heights.insert(map.heights.end(), row.begin(), row.end());
  return map;
}

/// A value for no data is a height of this depth where nothing declares it.
void require_data(const std::string& name, const NumberTable& table) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (std::find(table.rows[i].begin(), table.rows[i].end(), usual_no_data) == table.rows[i].end()) continue;
    throw MeshFault(name + ':' + std::to_string(table.lines[i]),
                    "the height " + shortest(usual_no_data) +
                        ", which usually means no data; allowed: heights, or an .asc file with NODATA_value");
  }
}

/// A word of a line as a number, which may have a decimal comma.
double decimal(const TextLines& lines, std::size_t word) {
  if (word >= lines.words().size()) return lines.number(word);  // a fault
  std::string text(lines.words()[word]);
  std::replace(text.begin(), text.end(), ',', '.');
  return lines.number_of(text);
}

/// An ASCII grid: lines of a name and a value, then heights in any lines, from the north-west.
HeightMap read_ascii_grid(const std::string& name, const std::string& content) {
  TextLines lines(name, content, 0);
  std::map<std::string, double> header{{"nodata_value", usual_no_data}};
  std::vector<double> heights;
  while (lines.next()) {
    const std::string keyword = lower(lines.keyword());
    if (heights.empty() && std::isalpha(static_cast<unsigned char>(keyword[0])) && keyword != "nan") {
      static constexpr std::string_view known[] = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                                   "xllcenter", "yllcenter", "cellsize",  "nodata_value"};
      if (std::find(std::begin(known), std::end(known), keyword) == std::end(known))
        lines.fail("unknown: \"" + std::string(lines.keyword()) + "\"; allowed: " + joined(known));
      header[keyword] = decimal(lines, 1);
      continue;
    }
    for (std::size_t i = 0; i < lines.words().size(); ++i) heights.push_back(decimal(lines, i));
  }
  for (const char* key : {"ncols", "nrows", "cellsize"}) {
    if (!(header[key] > 0)) throw MeshFault(name, std::string(key) + " is missing or not above 0");
  }
  const double columns = header["ncols"], rows = header["nrows"], size = header["cellsize"];
  if (columns * rows != static_cast<double>(heights.size()) || columns != std::floor(columns)) {
    throw MeshFault(name, std::to_string(heights.size()) + " heights; allowed: ncols times nrows, " +
                              shortest(columns) + " times " + shortest(rows));
  }
  for (double& height : heights)
    if (height == header["nodata_value"]) height = no_data;
  HeightMap map{.columns = static_cast<std::size_t>(columns),
                .rows = static_cast<std::size_t>(rows),
                .heights = std::move(heights),
                .spacing = size};
  const char* const axes[] = {"x", "y"};
  for (std::size_t axis = 0; axis < 2; ++axis) {  // the corner of a cell, or the node at its centre
    const std::string key = axes[axis] + std::string("ll");
    if (header.contains(key + "corner")) map.south_west[axis] = header[key + "corner"] + size / 2;
    if (header.contains(key + "center")) map.south_west[axis] = header[key + "center"];
  }
  return map;
}

}  // namespace

HeightMap read_heights(const std::string& name, const std::string& content) {
  TextLines lines(name, content, '#');
  if (lines.next() && lower(lines.keyword()) == "ncols") return read_ascii_grid(name, content);
  const NumberTable table = read_number_table(name, content, "heights");
  require_data(name, table);
  const std::optional<HeightMap> list = map_of_list(name, table);
  return list ? *list : map_of_grid(table);
}

double spacing_of(const HeightMap& map, const std::string& name, double given) {
  if (map.columns < 2 || map.rows < 2)
    throw MeshFault(name, "fewer than two rows or columns of heights; allowed: two or more of each");
  if (!map.spacing) {
    if (given > 0) return given;
    throw MeshFault(name, "heights without coordinates; required: spacing");
  }
  if (given > 0 && std::abs(given - *map.spacing) > rounding * given) {
    throw MeshFault(name, "nodes at distances of " + shortest(*map.spacing) + " m; spacing is " +
                              shortest(given) + " m; allowed: the same, or no spacing with an .asc file");
  }
  return *map.spacing;
}

}  // namespace halfspace::cli
