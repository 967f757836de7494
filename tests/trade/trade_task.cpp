// The program of one engine: `list` names what it can run, `run N` runs that and prints a row. README.md
// tells more.

#include <cmath>
#include <cstdio>

#include "list_or_run.h"
#include "tasks.h"

namespace halfspace_trade {
namespace {

constexpr double short_run = 0.05;  // s of processor time; a clock tells less of what is shorter
constexpr int most_repeats = 5;

struct Case {
  Task task;
  Setting setting;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Task& task : tasks())
    for (const Setting& setting : settings())
      if (knows_dimension(task.dimension)) all.push_back({task, setting});
  return all;
}

void print_name(const Case& c) {
  std::printf("%s|%d|%s|%s|%g|%.6g", c.task.name.c_str(), c.task.dimension, engine_name(),
              c.setting.way.c_str(), c.setting.indentation, c.setting.step);
}

void run(const Case& c) {
  Trial trial(c.setting);
  const double value = c.task.value(trial);
  double seconds = trial.cpu_seconds();
  for (int i = 1; i < most_repeats && trial.cpu_seconds() < short_run; ++i) {
    Trial again(c.setting);
    c.task.value(again);
    seconds = std::min(seconds, again.cpu_seconds());
  }
  print_name(c);
  std::printf("|%.4g|%.12g|%.12g|%.4g|%.4g\n", trial.time_step(), value, c.task.exact,
              std::abs(value - c.task.exact) / c.task.scale, seconds / trial.simulated());
}

}  // namespace
}  // namespace halfspace_trade

int main(int argc, char** argv) {
  using namespace halfspace_trade;
  return list_or_run(argc, argv, cases, print_name, run);
}
