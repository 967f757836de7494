#pragma once

#include <string>

#include "common/archive.h"
#include "model/model.h"

namespace halfspace::cli {

/// history.csv: a row for each output time, with time, energies, contacts, and the motion of the tracked
/// blocks.
class History {
 public:
  History(const Scene& scene, const Layout& layout);
  void add(const Model& model);
  void add_to(Archive& archive) { archive.add(text_); }
  const std::string& text() const { return text_; }

 private:
  bool has_water_, has_bolts_;
  std::string text_;
};

}  // namespace halfspace::cli
