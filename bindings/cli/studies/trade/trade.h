#pragma once

#include <string>

#include "common/files.h"
#include "studies/trade/front.h"

namespace halfspace::cli {

struct TradeOptions {
  double tolerance = 0.01;
  double budget = 0;     ///< s; 0: none
  bool resumes = false;  ///< from the runs in the directory
};

struct TradeResult {
  std::string report;
  bool is_interrupted = false;
  bool has_results = false;  ///< some run has reached its end
};

/// Runs the scene with each setting, the cheap ones first, and writes `trade.csv` after each; then
/// `trade.txt` and, if a run has reached its end, `trade.svg`. `scene_text` has the bytes of the scene: runs
/// are resumed only for the same bytes. @throws LibraryError, std::runtime_error
TradeResult trade(const Scene& scene, const std::string& scene_text, const TradeOptions& options,
                  OutputDirectory& directory);

}  // namespace halfspace::cli
