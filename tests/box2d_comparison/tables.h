#pragma once

// What a comparison leaves: scenes.csv, steps.csv, summary.csv. README.md says what their columns are.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "motion.h"
#include "pair_quality.h"
#include "scenes.h"

namespace box2d_comparison {

/// One CSV file. Texts are put in quotes where need be; what is not there is an empty field.
class Table {
 public:
  Table(const std::filesystem::path& path, const std::string& header);

  Table& add(const std::string& text);
  Table& add(double number);
  Table& add(std::int64_t number) { return add(std::to_string(number)); }
  Table& add(const std::optional<double>& number) { return number ? add(*number) : add(std::string()); }
  void end_row();

 private:
  std::ofstream file_;
  bool row_begun_ = false;
};

class Tables {
 public:
  /// Throws std::runtime_error when a file cannot be made.
  explicit Tables(const std::filesystem::path& folder);

  /// `stiffness` is that of force mode, in N/m, where there is such a world.
  void add(const Scene& scene, std::optional<double> stiffness);
  void add(const Scene& scene, const std::string& world, const std::vector<MotionRow>& rows);
  /// Without `quality` for worlds whose answers were not recorded.
  void add(const Scene& scene, const std::string& world, int sub_steps, const MotionSummary& motion,
           const PairQuality* quality, std::int64_t quiet_pairs);

 private:
  Table scenes_, steps_, summary_;
};

}  // namespace box2d_comparison
