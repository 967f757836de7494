#pragma once

#include <string>

#include "common/archive.h"
#include "model/model.h"

namespace halfspace::cli {

/// bolts.csv: a row for each installed bolt and each row of the history.
class BoltHistory {
 public:
  explicit BoltHistory(int dimension);
  void add(const Model& model);
  void add_to(Archive& archive) { archive.add(text_); }
  const std::string& text() const { return text_; }

 private:
  int dimension_;
  std::string text_;
};

}  // namespace halfspace::cli
