#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/files.h"
#include "output/progress.h"
#include "scene/scene.h"
#include "studies/safety/trials.h"

namespace halfspace::cli {

struct SearchOptions {
  double low = 0.5;           ///< the bracket: at one end the scene is stable
  double high = 5;            ///< at the other it falls
  double resolution = 0.005;  ///< final width of the bracket
  double limit = 0;           ///< m, displacement of a fallen block; 0: that of the trials
  bool smallest = false;      ///< stable at the high end
  bool resumes = false;       ///< from the trials in the directory
  ProgressListener on_progress = {};
};

enum class SearchEnd {
  found,
  not_found,  ///< the scene does not come to rest, falls at the stable end, or is stable at the other
  interrupted
};

struct SearchResult {
  std::string report;
  SearchEnd end = SearchEnd::not_found;
  std::optional<double> stands = {}, falls = {};  ///< the bracket
};

/// The words of a search in its report and its files.
struct SearchWords {
  std::string sought;  ///< as in the report: "factor of safety"
  std::string column;  ///< of trials.csv
  std::string report;  ///< name of the report's file
};

/// Bisects the largest, or the smallest, value at which a scene is stable. Writes each trial, cracks,
/// pictures of the stable scene and of its failure, and the report, whose first lines are given. `identity`
/// identifies the scene and the search, for resuming. @throws LibraryError, std::runtime_error
SearchResult search(const Scene& scene, Trials::Begin begin, const SearchWords& words,
                    const SearchOptions& options, const std::string& identity, const std::string& first_lines,
                    Progress& progress, OutputDirectory& directory);

}  // namespace halfspace::cli
