#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace halfspace::viewer {

/// The storage of a column's values.
enum class Coding {
  lattice,  ///< whole multiples of a step
  rounded,  ///< bfloat16: the upper half of a float, with a relative error of at most 1/256
  coarse,   ///< likewise, with a relative error of at most 1/32
  flag      ///< 0 unless it is set
};

/// A quantity of all items of a table, over the frames of a group.
struct Column {
  std::string name;
  std::string unit = {};
  Coding coding = Coding::rounded;
  double step = 1;                               ///< of the lattice
  std::vector<std::vector<double>> frames = {};  ///< a value of each item; NaN: unset
};

/// Values of the same quantity, over all frames of a recording.
struct Range {
  double low = INFINITY, high = -INFINITY;
  std::vector<double> samples;  ///< every so many values
  std::size_t stride = 1, passed = 0;

  void add(double value);
  /// The value that a fraction of the samples does not exceed.
  double quantile(double fraction) const;
};

/// A table of items, such as blocks or contacts, whose values change from frame to frame. Frames are packed
/// in groups; a group is a list of whole numbers, which are stored as they are, or as their differences from
/// frame to frame.
class Table {
 public:
  Table(std::string name, std::vector<Column> columns);

  /// Adds a column, or finds it by its name.
  std::size_t column(const std::string& name, const std::string& unit);
  void begin_frame();
  /// Sets a value of the current frame, which counts for the range of the column or not.
  void set(std::size_t column, std::size_t item, double value, bool is_in_range = true);
  std::size_t item_count() const { return item_count_; }
  const std::string& name() const { return name_; }

  /// The frames of the group as bytes.
  std::string pack() const;
  /// Begins the next group; without `keeps_items`, that has items of its own.
  void clear(bool keeps_items);
  /// The names, units, codings and ranges of the columns, as JSON.
  std::string description() const;

 private:
  std::string name_;
  std::vector<Column> columns_;
  std::vector<Range> ranges_;
  std::size_t item_count_ = 0;
  std::size_t frame_count_ = 0;
};

}  // namespace halfspace::viewer
