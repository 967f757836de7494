#include "common/suggestion.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace halfspace::cli {
namespace {

/// Levenshtein distance: the number of letters to insert, delete or change.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view name, const std::vector<std::string_view>& names) {
  std::string_view found;
  std::size_t min_distance = 1 + std::max<std::size_t>(2, name.size() / 3);  // farther names are other words
  for (std::string_view candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < min_distance) {
      min_distance = distance;
      found = candidate;
    }
  }
  return found;
}

std::string suggestion(std::string_view name, const std::vector<std::string_view>& names) {
  const std::string_view near = nearest(name, names);
  return near.empty() ? "" : " (did you mean '" + std::string(near) + "'?)";
}

}  // namespace halfspace::cli
