#include "studies/trade/trade.h"

#include <algorithm>
#include <chrono>

#include "common/interrupt.h"
#include "output/progress.h"
#include "studies/trade/chart.h"
#include "studies/trade/measure.h"
#include "studies/trade/report.h"
#include "studies/trade/runs.h"

namespace halfspace::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The ladder of steps comes early, as it shows the convergence.
double priority(const Setting& setting) {
  const bool is_on_ladder = setting == Setting{.step = setting.step};
  return expected_cost(setting) * (is_on_ladder ? 0.1 : 1);
}

std::vector<Setting> in_order(std::vector<Setting> runs) {
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Setting& p, const Setting& q) { return priority(p) < priority(q); });
  return runs;
}

bool holds(const std::vector<Result>& results, const Setting& setting) {
  return std::any_of(results.begin(), results.end(),
                     [&](const Result& result) { return result.setting == setting; });
}

/// Estimates the cost of a run from those that are done.
class CostEstimate {
 public:
  void add(const Result& result) {
    expected_ += expected_cost(result.setting);
    seconds_ += result.outcomes.cpu_seconds;
  }
  double seconds(const Setting& setting) const {
    return expected_ > 0 ? seconds_ / expected_ * expected_cost(setting) : 0;
  }

 private:
  double expected_ = 0, seconds_ = 0;
};

class Runner {
 public:
  Runner(const Scene& scene, const std::string& scene_text, const TradeOptions& options,
         OutputDirectory& directory)
      : scene_(scene),
        scene_text_(scene_text),
        options_(options),
        directory_(directory),
        face_(typical_face(scene)) {
    if (!options.resumes) return;
    const std::string file = (directory.path() / "trade.csv").string();
    try {
      results_ = results_from(content_of(file), scene_text);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("cannot resume from " + file + ": " + error.what());
    }
  }

  TradeResult run() {
    TradeResult result;
    int left_out = 0;
    std::vector<Setting> runs = in_order(runs_of(scene_, names_cells(scene_)));
    std::erase_if(runs, [&](const Setting& setting) { return holds(results_, setting); });
    CostEstimate estimate;
    for (const Result& done : results_) estimate.add(done);
    double expected = 0, done = 0;
    for (const Setting& setting : runs) expected += expected_cost(setting);
    Progress progress;
    for (const Setting& setting : runs) {
      done += expected_cost(setting);
      if (!fits_budget(estimate.seconds(setting))) {
        ++left_out;
        continue;
      }
      const Outcomes outcomes = measure(setting, scene_, face_);
      result.is_interrupted = outcomes.end == RunEnd::interrupted;
      if (result.is_interrupted) break;
      results_.push_back({setting, outcomes});
      estimate.add(results_.back());
      directory_.write("trade.csv", csv_of(results_, scene_text_));
      progress.show(done / expected, describe(setting));
    }
    const Front front(scene_, results_);
    result.has_results = std::any_of(results_.begin(), results_.end(), Front::counts);
    result.report = report(scene_, front, face_, options_.tolerance, left_out);
    directory_.write("trade.csv", csv_of(results_, scene_text_));
    directory_.write("trade.txt", result.report);
    if (result.has_results) directory_.write("trade.svg", chart(scene_, front));
    return result;
  }

 private:
  bool fits_budget(double seconds) const {
    return options_.budget == 0 || seconds_since(start_) + seconds <= options_.budget;
  }

  const Scene& scene_;
  const std::string& scene_text_;
  const TradeOptions& options_;
  OutputDirectory& directory_;
  FaceSize face_;
  std::vector<Result> results_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

TradeResult trade(const Scene& scene, const std::string& scene_text, const TradeOptions& options,
                  OutputDirectory& directory) {
  remember_interrupts();
  return Runner(scene, scene_text, options, directory).run();
}

}  // namespace halfspace::cli
