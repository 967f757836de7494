#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "recording/recording.h"

namespace halfspace::viewer {

/// A file of VTK XML PolyData as runs write it: cells with data at points, all arrays raw.
class VtkFrame {
 public:
  /// `file` is the name in messages. @throws std::runtime_error that names the file if it is none of a run
  VtkFrame(const std::string& content, std::string file);

  const std::string& file() const { return file_; }
  const std::vector<Point>& points() const { return points_; }
  std::size_t cell_count() const { return offsets_.size(); }
  /// The points of a cell.
  std::vector<std::size_t> cell(std::size_t index) const;

  bool has(const std::string& name) const { return data_.contains(name); }
  /// A component of a cell's data. @throws std::runtime_error if there is no such array
  double value(const std::string& name, std::size_t cell, std::size_t component = 0) const;
  std::size_t index(const std::string& name, std::size_t cell) const;
  Point vector(const std::string& name, std::size_t cell) const;

 private:
  struct Array {
    std::size_t components = 1;
    std::vector<double> values = {};
  };
  const Array& array(const std::string& name) const;

  std::string file_;
  std::vector<Point> points_;
  std::vector<std::int64_t> connectivity_, offsets_;
  std::map<std::string, Array> data_;
};

/// The times and files of a ParaView collection (.pvd) that a run has written, from its content.
std::vector<std::pair<double, std::string>> read_collection(const std::string& content);

}  // namespace halfspace::viewer
