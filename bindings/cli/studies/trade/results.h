#pragma once

#include <string>
#include <vector>

#include "studies/trade/quantity.h"
#include "studies/trade/setting.h"

namespace halfspace::cli {

/// One run of a trade.
struct Result {
  Setting setting;
  Outcomes outcomes;
};

/// All runs as CSV, after a line that identifies the scene.
std::string csv_of(const std::vector<Result>& results, const std::string& scene_text);

/// The runs of such a table. @throws std::runtime_error for a table of another scene, or an invalid one
std::vector<Result> results_from(const std::string& csv, const std::string& scene_text);

}  // namespace halfspace::cli
