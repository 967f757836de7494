#pragma once

#include <string>

#include "files.h"
#include "trade/front.h"

namespace halfspace::cli {

struct TradeOptions {
  double tolerance = 0.01;
  double budget = 0;     ///< s; 0: none
  bool resumes = false;  ///< goes on from the runs that the directory holds
};

struct TradeResult {
  std::string report;
  bool is_interrupted = false;
  bool has_results = false;  ///< some run went to its end
};

/// Runs the scene with its knobs turned, one by one, the cheap ones first, and writes after each what is
/// known: `trade.csv`, `trade.txt` and, when a run went to its end, `trade.svg`. `scene_text` are the bytes
/// that make the scene: its runs are resumed only with the same ones. @throws LibraryError,
/// std::runtime_error
TradeResult trade(const Scene& scene, const std::string& scene_text, const TradeOptions& options,
                  OutputDirectory& directory);

}  // namespace halfspace::cli
