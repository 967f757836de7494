#include "vtk_series.h"

#include <bit>
#include <cstdint>
#include <cstdio>

#include "text.h"

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

void append_vector(std::vector<double>& values, double x, double y) {
  values.insert(values.end(), {x, y, 0.0});
}

std::string cell_data(const Frame& frame, const Frame& start, Appended& data) {
  std::vector<std::int64_t> block;
  std::vector<std::int32_t> kind, material;
  std::vector<double> velocity, displacement, angle, spin, force;
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const hs_block_state& now = frame.blocks[i].state;
    const hs_block_state& then = start.blocks[i].state;
    block.push_back(static_cast<std::int64_t>(i));
    kind.push_back(now.kind);
    material.push_back(now.material);
    append_vector(velocity, now.velocity[0], now.velocity[1]);
    append_vector(displacement, now.pose.position[0] - then.pose.position[0],
                  now.pose.position[1] - then.pose.position[1]);
    angle.push_back(now.angle);
    spin.push_back(now.angular_velocity[2]);
    append_vector(force, now.force[0], now.force[1]);
  }
  return "<CellData>\n" + data.add("Int64", "block", 1, block) + data.add("Int32", "kind", 1, kind) +
         data.add("Int32", "material", 1, material) + data.add("Float64", "velocity", 3, velocity) +
         data.add("Float64", "displacement", 3, displacement) + data.add("Float64", "angle", 1, angle) +
         data.add("Float64", "angular_velocity", 1, spin) + data.add("Float64", "contact_force", 3, force) +
         "</CellData>\n";
}

}  // namespace

std::string vtk_polygons(const Frame& frame, const Frame& start) {
  std::vector<double> points;
  std::vector<std::int64_t> connectivity, offsets;
  for (const BlockFrame& block : frame.blocks) {
    for (const Point& p : block.vertices) {
      connectivity.push_back(static_cast<std::int64_t>(connectivity.size()));
      append_vector(points, p[0], p[1]);
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  Appended data;
  const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text =
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"") +
      order + "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  text += "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
          shortest(frame.time) + "</DataArray>\n</FieldData>\n";
  text += "<Piece NumberOfPoints=\"" + std::to_string(connectivity.size()) + "\" NumberOfPolys=\"" +
          std::to_string(offsets.size()) + "\">\n";
  text += cell_data(frame, start, data);
  text += "<Points>\n" + data.add("Float64", "points", 3, points) + "</Points>\n";
  text += "<Polys>\n" + data.add("Int64", "connectivity", 1, connectivity) +
          data.add("Int64", "offsets", 1, offsets) + "</Polys>\n";
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data.bytes() +
          "\n</AppendedData>\n</VTKFile>\n";
  return text;
}

void VtkSeries::add(const Frame& frame, const Frame& start) {
  char name[32];
  std::snprintf(name, sizeof name, "frames/frame_%04d.vtp", count_++);
  directory_.write(name, vtk_polygons(frame, start));
  entries_ += "<DataSet timestep=\"" + shortest(frame.time) + "\" part=\"0\" file=\"" + name + "\"/>\n";
  directory_.write("run.pvd",
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
                       entries_ + "</Collection>\n</VTKFile>\n");
}

}  // namespace halfspace::cli
