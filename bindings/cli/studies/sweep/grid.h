#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace halfspace::cli {

/// A key and its values, as texts for `key=value`.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// All combinations of the values of several keys. The last key varies fastest.
struct Grid {
  std::vector<std::string> fixed;  ///< settings with one value
  std::vector<Axis> axes;

  std::size_t count() const;
  /// The value of each axis in a combination.
  std::vector<std::string> values_of(std::size_t number) const;
  /// The settings of a combination.
  std::vector<std::string> settings_of(std::size_t number) const;
};

/// The values of `a,b,c` or of a range `first:last:step`, which holds its ends. Commas within brackets and
/// quotes divide nothing. Ranges are exact in decimals. @throws std::invalid_argument
std::vector<std::string> values_from(const std::string& text);

/// The grid of settings `key=values`. @throws std::invalid_argument
Grid grid_of(const std::vector<std::string>& settings);

}  // namespace halfspace::cli
