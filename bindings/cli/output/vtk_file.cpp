#include "output/vtk_file.h"

#include <bit>

#include "common/text.h"

namespace halfspace::cli {
namespace {

/// The raw arrays behind a VTK XML file, each with its length in bytes before it.
class Appended {
 public:
  /// Adds an array and returns the element that describes it.
  template <class Number>
  std::string add(const char* type, const char* name, int components, const std::vector<Number>& values) {
    const std::string element = std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
                                "\" NumberOfComponents=\"" + std::to_string(components) +
                                "\" format=\"appended\" offset=\"" + std::to_string(bytes_.size()) + "\"/>\n";
    append(std::uint64_t{values.size() * sizeof(Number)});
    for (const Number& value : values) append(value);
    return element;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  void append(const Number& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::string bytes_;
};

}  // namespace

std::string vtk_text(const VtkCells& cells) {
  Appended data;
  const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text =
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"") +
      order + "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  text += "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
          shortest(cells.time) + "</DataArray>\n</FieldData>\n";
  text += "<Piece NumberOfPoints=\"" + std::to_string(cells.points.size() / 3) + "\" NumberOf" + cells.kind +
          "=\"" + std::to_string(cells.offsets.size()) + "\">\n<CellData>\n";
  for (const VtkIntegers& array : cells.integers) text += data.add("Int64", array.name, 1, array.values);
  for (const VtkArray& array : cells.arrays)
    text += data.add("Float64", array.name, array.components, array.values);
  text += "</CellData>\n<Points>\n" + data.add("Float64", "points", 3, cells.points) + "</Points>\n<" +
          cells.kind + ">\n" + data.add("Int64", "connectivity", 1, cells.connectivity) +
          data.add("Int64", "offsets", 1, cells.offsets) + "</" + cells.kind + ">\n";
  return text + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data.bytes() +
         "\n</AppendedData>\n</VTKFile>\n";
}

std::string vtk_collection(const std::string& entries) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" + entries +
         "</Collection>\n</VTKFile>\n";
}

std::string vtk_entry(double time, const std::string& file) {
  return "<DataSet timestep=\"" + shortest(time) + "\" part=\"0\" file=\"" + file + "\"/>\n";
}

}  // namespace halfspace::cli
