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

/// One value or vector for each cell.
struct CellArray {
  void add(const double* components) { values.insert(values.end(), components, components + count); }

  const char* name;
  int count;  ///< of components
  std::vector<double> values = {};
};

/// What 2D and 3D tell differently: how a block is turned and turns.
void add_turning(const hs_block_state& state, CellArray& turned, CellArray& spin) {
  turned.add(turned.count == 1 ? &state.angle : state.pose.rotation);
  spin.add(spin.count == 1 ? &state.angular_velocity[2] : state.angular_velocity);
}

std::string cell_data(const Layout& layout, const Frame& frame, const Frame& start, Appended& data) {
  const bool in_plane = layout.dimension == 2;
  std::vector<std::int64_t> block;
  std::vector<std::int32_t> kind, material;
  CellArray velocity{"velocity", 3}, displacement{"displacement", 3}, force{"contact_force", 3};
  CellArray turned = in_plane ? CellArray{"angle", 1} : CellArray{"rotation", 4};
  CellArray spin{"angular_velocity", in_plane ? 1 : 3};
  CellArray stress{"stress", 9}, strain{"strain", 9};
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const hs_block_state& now = frame.blocks[i].state;
    const hs_block_state& then = start.blocks[i].state;
    double moved[3];
    for (int axis = 0; axis < 3; ++axis) moved[axis] = now.pose.position[axis] - then.pose.position[axis];
    for (std::size_t face = 0; face < layout.blocks[i].faces.size(); ++face) {
      block.push_back(static_cast<std::int64_t>(i));
      kind.push_back(now.kind);
      material.push_back(now.material);
      velocity.add(now.velocity);
      displacement.add(moved);
      add_turning(now, turned, spin);
      force.add(now.force);
      stress.add(frame.blocks[i].deformation.stress);
      strain.add(frame.blocks[i].deformation.strain);
    }
  }
  std::string text = "<CellData>\n";
  text += data.add("Int64", "block", 1, block);
  text += data.add("Int32", "kind", 1, kind);
  text += data.add("Int32", "material", 1, material);
  for (const CellArray* array : {&velocity, &displacement, &turned, &spin, &force})
    text += data.add("Float64", array->name, array->count, array->values);
  if (layout.has_affine()) {
    for (const CellArray* array : {&stress, &strain})
      text += data.add("Float64", array->name, array->count, array->values);
  }
  return text + "</CellData>\n";
}

}  // namespace

std::string vtk_polygons(const Layout& layout, const Frame& frame, const Frame& start) {
  std::vector<double> points;
  std::vector<std::int64_t> connectivity, offsets;
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const std::size_t first = points.size() / 3;
    for (const Point& p : frame.blocks[i].vertices) points.insert(points.end(), p.begin(), p.end());
    for (const std::vector<int>& face : layout.blocks[i].faces) {
      for (int vertex : face) connectivity.push_back(static_cast<std::int64_t>(first) + vertex);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  }
  Appended data;
  const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text =
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"") +
      order + "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  text += "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
          shortest(frame.time) + "</DataArray>\n</FieldData>\n";
  text += "<Piece NumberOfPoints=\"" + std::to_string(points.size() / 3) + "\" NumberOfPolys=\"" +
          std::to_string(offsets.size()) + "\">\n";
  text += cell_data(layout, frame, start, data);
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
  directory_.write(name, vtk_polygons(layout_, frame, start));
  entries_ += "<DataSet timestep=\"" + shortest(frame.time) + "\" part=\"0\" file=\"" + name + "\"/>\n";
  directory_.write("run.pvd",
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
                       entries_ + "</Collection>\n</VTKFile>\n");
}

}  // namespace halfspace::cli
