#pragma once

#include <string>
#include <vector>

#include "trade/quantity.h"
#include "trade/setting.h"

namespace halfspace::cli {

/// One run of a trade.
struct Result {
  Setting setting;
  Outcomes outcomes;
};

/// All runs as a table, a row each, behind a line that tells the scene apart from others.
std::string csv_of(const std::vector<Result>& results, const std::string& scene_text);

/// The rows of such a table. @throws std::runtime_error when it is of another scene, or no such table
std::vector<Result> results_from(const std::string& csv, const std::string& scene_text);

}  // namespace halfspace::cli
