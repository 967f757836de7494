#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::cli {

/// One value or vector for each cell.
struct VtkArray {
  VtkArray(const char* name, int components) : name(name), components(components) {}
  void add(const double* value) { values.insert(values.end(), value, value + components); }
  void add(double value) { values.push_back(value); }

  const char* name;
  int components;
  std::vector<double> values;
};

struct VtkIntegers {
  const char* name;
  std::vector<std::int64_t> values = {};
};

/// Cells at points, at one time.
struct VtkCells {
  const char* kind;                 ///< "Polys", "Lines" or "Verts"
  double time = 0;                  ///< s
  std::vector<double> points = {};  ///< three coordinates each
  std::vector<std::int64_t> connectivity = {}, offsets = {};
  std::vector<VtkIntegers> integers = {};
  std::vector<VtkArray> arrays = {};
};

/// The cells as a file of VTK XML PolyData, with raw arrays.
std::string vtk_text(const VtkCells& cells);

/// A ParaView collection (.pvd), with the times of other files.
std::string vtk_collection(const std::string& entries);
/// An entry of a collection.
std::string vtk_entry(double time, const std::string& file);

}  // namespace halfspace::cli
