#pragma once

#include <string>

#include "commands/checked_scene.h"
#include "common/files.h"
#include "run/run.h"
#include "studies/plan/plan.h"
#include "studies/safety/safety.h"
#include "studies/trade/trade.h"

// The subcommands. Each prints its report and returns the exit code. They throw LibraryError and
// std::runtime_error.

namespace halfspace::cli {

/// The directory that a command writes to, and the number of its threads; 0: that of the scene.
struct Target {
  std::string directory;
  Earlier earlier = Earlier::refuse;
  int threads = 0;
};

/// The directory of a study, which continues from a file in it or begins.
OutputDirectory directory_of(const Target& target, bool resumes, const std::string& file);

/// The directory of a run, and its options with the state of the checkpoint, unless `from` is empty.
struct RunStart {
  RunOptions options;
  OutputDirectory directory;
};
RunStart begin_run(const Target& target, RunOptions options, const std::string& from);

int check(const SceneFile& file);

/// From a checkpoint, unless `from` is empty.
int run(const SceneFile& file, const Target& target, RunOptions options, const std::string& from,
        RunResult& result);

int trade(const SceneFile& file, const Target& target, const TradeOptions& options);

int plan(const SceneFile& file, const PlanOptions& options);

int safety(const SceneFile& file, const Target& target, const SearchOptions& options, SearchResult& result);

/// Writes the run in a directory as one page of HTML; to view.html in it, unless `file` is given.
int view(const std::string& directory, const std::string& file);

}  // namespace halfspace::cli
