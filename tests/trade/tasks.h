#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trial.h"

namespace halfspace_trade {

/// A scene with a known answer. Its error is that of the value from the exact one, in parts of the scale.
struct Task {
  std::string name;
  int dimension;
  double exact;
  double scale;
  std::function<double(Trial&)> value;
};

std::vector<Task> tasks();

}  // namespace halfspace_trade
