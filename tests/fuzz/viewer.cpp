// Runs that the viewer shows: whatever their files hold, a fault is told, or there is a page; blocks of a run
// as the command writes it are on the page as they were written. The C interface takes any calls.

#include <halfspace/viewer.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "fuzz/bytes.h"
#include "fuzz/demand.h"
#include "output/vtk_file.h"
#include "recording/run_folder.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace;
using viewer::Point;

const std::string place_of_recording = "<!-- recording -->";

struct MadeBlock {
  std::size_t number = 0;
  int kind = 2;
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;
};

Point point(Bytes& bytes) { return {bytes.number(), bytes.number(), bytes.number()}; }

/// Faces in any order, of vertices in any order, all of which they have.
std::vector<std::vector<int>> make_faces(Bytes& bytes, int vertex_count) {
  std::vector<int> order(static_cast<std::size_t>(vertex_count));
  std::iota(order.begin(), order.end(), 0);
  for (int i = vertex_count; i-- > 1;)
    std::swap(order[std::size_t(i)], order[std::size_t(bytes.below(i + 1))]);
  std::vector<std::vector<int>> faces(1);
  for (const int vertex : order) {
    if (faces.back().size() > 2 && bytes.flag()) faces.emplace_back();
    faces.back().push_back(vertex);
  }
  for (int extra = bytes.below(3); extra > 0; --extra)
    faces.push_back({bytes.below(vertex_count), bytes.below(vertex_count), bytes.below(vertex_count)});
  return faces;
}

std::vector<MadeBlock> make_blocks(Bytes& bytes) {
  std::vector<MadeBlock> blocks(std::size_t(bytes.between(1, 3)));
  std::size_t next = 0;
  for (MadeBlock& block : blocks) {
    block.number = next + std::size_t(bytes.below(8) == 0);
    next = block.number + 1;
    block.kind = bytes.below(5);
    const int vertex_count = bytes.between(3, 8);
    for (int v = 0; v < vertex_count; ++v) block.vertices.push_back(point(bytes));
    block.faces = make_faces(bytes, vertex_count);
  }
  return blocks;
}

std::string frame_of(Bytes& bytes, int dimension, const std::vector<MadeBlock>& blocks, const Point& shift) {
  cli::VtkCells cells{.kind = "Polys"};
  cli::VtkIntegers number{"block"}, kind{"kind"}, material{"material"};
  cli::VtkArray velocity("velocity", 3), spin("angular_velocity", dimension == 2 ? 1 : 3),
      rotation(dimension == 2 ? "angle" : "rotation", dimension == 2 ? 1 : 4), force("contact_force", 3);
  for (const MadeBlock& block : blocks) {
    const auto first = static_cast<std::int64_t>(cells.points.size() / 3);
    for (const Point& vertex : block.vertices)
      for (std::size_t axis = 0; axis < 3; ++axis) cells.points.push_back(vertex[axis] + shift[axis]);
    const double turned[] = {bytes.number(), 0.5, -0.5, 0.5}, value[] = {bytes.number(), 1, 2};
    for (const std::vector<int>& face : block.faces) {
      for (const int vertex : face) cells.connectivity.push_back(first + vertex);
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      number.values.push_back(static_cast<std::int64_t>(block.number));
      kind.values.push_back(block.kind);
      material.values.push_back(0);
      for (cli::VtkArray* array : {&velocity, &spin, &force}) array->add(value);
      rotation.add(turned);
    }
  }
  cells.integers = {number, kind, material};
  cells.arrays = {velocity, spin, rotation, force};
  return vtk_text(cells);
}

using Files = std::map<std::string, std::string>;

viewer::Recording read(const Files& files) {
  return viewer::read_run(
      [&](const std::string& name) -> std::optional<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return found->second;
      },
      "run");
}

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

/// A block keeps its faces and the distances of its vertices, but for rounding of the coordinates.
void compare(const viewer::BlockShape& shown, const MadeBlock& made) {
  demand(shown.faces == made.faces, "a block has the faces that were written");
  demand(shown.vertices.size() == made.vertices.size(), "a block has the vertices that were written");
  double largest = std::numeric_limits<double>::min() * 0x1p53;  // below it numbers have fewer digits
  for (const Point& p : made.vertices)
    for (const double coordinate : p) largest = std::max(largest, std::abs(coordinate));
  for (std::size_t i = 0; i < made.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      demand(std::abs(distance(shown.vertices[i], shown.vertices[j]) -
                      distance(made.vertices[i], made.vertices[j])) <= 0x1p-46 * largest,
             "a block has the shape that was written");
}

void check(viewer::Recording recording) {
  for (std::size_t b = 0; b < recording.block_count(); ++b) {
    const viewer::BlockShape& shape = recording.shape(b);
    for (const Point& vertex : shape.vertices)
      for (const double coordinate : vertex) demand(std::isfinite(coordinate), "a vertex has a place");
    for (const std::vector<int>& face : shape.faces)
      for (const int vertex : face)
        demand(vertex >= 0 && std::size_t(vertex) < shape.vertices.size(),
               "faces are of vertices that there are");
  }
  demand(recording.page(place_of_recording).find("id=\"group-0\"") != std::string::npos,
         "a page has its frames");
}

/// The files that a run can have, all frames of it in one file.
Files files_of(const std::string& frame, int frame_count) {
  std::string entries;
  for (int f = 0; f < frame_count; ++f) entries += cli::vtk_entry(f, "frame");
  return {{"run.pvd", cli::vtk_collection(entries)},
          {"frame", frame},
          {"blocks.csv",
           "number,name,material_number,material\n0,a,0,rock\n1,b,0,rock\n2,c,0,\n3,d,1,\n4,e,0,\n5,f,0,\n"},
          {"cracks.csv", "time,block_a,block_b,x,y\n0,a,b,1,2\n1,a,d,1,2\n"}};
}

/// A run of blocks as the command writes it.
void read_made_run(Bytes& bytes) {
  const int dimension = bytes.between(2, 3);
  const std::vector<MadeBlock> blocks = make_blocks(bytes);
  Files files = files_of(frame_of(bytes, dimension, blocks, {}), bytes.between(1, 2));
  files["run.pvd"] += cli::vtk_entry(bytes.number(), "moved");
  files["moved"] = frame_of(bytes, dimension, blocks, point(bytes));
  try {
    viewer::Recording recording = read(files);
    for (const MadeBlock& block : blocks) compare(recording.shape(block.number), block);
    check(std::move(recording));
  } catch (const std::runtime_error& error) {
    demand(false, error.what());
  } catch (const std::invalid_argument& error) {
    demand(*error.what() != 0, "a fault has a text");  // places and rotations that a page cannot show
  }
}

/// A run of which any file has other bytes.
void read_damaged_run(Bytes& bytes) {
  Files files = files_of(frame_of(bytes, bytes.between(2, 3), make_blocks(bytes), {}), 1);
  for (const char* name : {"terrain.pvd", "contacts.pvd", "bolts.pvd", "water.pvd"})
    if (bytes.flag()) files[name] = files["run.pvd"];
  if (bytes.below(4) == 0) {
    files["frame"] = bytes.rest();
  } else {
    while (!bytes.empty()) {
      std::string& file = std::next(files.begin(), bytes.below(int(files.size())))->second;
      if (file.empty()) continue;
      const std::size_t place = bytes.raw<std::uint16_t>() % file.size();
      if (bytes.flag())
        file[place] = char(bytes.byte());
      else
        file.erase(place, bytes.byte());
    }
  }
  try {
    check(read(files));
  } catch (const std::runtime_error& error) {
    demand(*error.what() != 0, "a fault has a text");
  } catch (const std::invalid_argument& error) {
    demand(*error.what() != 0, "a fault has a text");
  }
}

/// A page with a place for a recording, as a file of this process.
const std::string& viewer_page() {
  static const std::string path = [] {
    const int file = memfd_create("viewer", 0);
    demand(write(file, place_of_recording.data(), place_of_recording.size()) > 0,
           "there is memory for the page");
    return "/proc/self/fd/" + std::to_string(file);
  }();
  return path;
}

void call(Bytes& bytes, hs_recording* recording) {
  const std::int64_t count = bytes.below(4);
  std::vector<double> values(32);
  for (double& value : values) value = bytes.number();
  std::vector<std::int64_t> numbers(4), others(4);
  for (std::int64_t& number : numbers) number = bytes.between(-1, 4);
  for (std::int64_t& number : others) number = bytes.below(4);
  std::vector<std::int32_t> wholes(16);
  for (std::int32_t& whole : wholes) whole = bytes.between(-1, 5);
  const std::vector<std::int32_t> sizes = {bytes.between(-1, 5), bytes.between(0, 5), bytes.between(0, 5)};
  switch (bytes.below(9)) {
    case 0:
      hs_recording_add_block(recording, "block", bytes.between(-1, 5), bytes.between(-1, 5), values.data(),
                             count + 2, values.data() + 7, std::min<std::int64_t>(count, 3), sizes.data(),
                             wholes.data());
      break;
    case 1:
      hs_recording_add_frame(recording, values[0]);
      break;
    case 2:
      hs_recording_set_poses(recording, count, numbers.data(), values.data());
      break;
    case 3:
      hs_recording_set_vertices(recording, numbers[0], values.data());
      break;
    case 4:
      hs_recording_set_values(recording, "speed", "m/s", count, numbers.data(), values.data());
      break;
    case 5:
      hs_recording_set_contacts(recording, count, numbers.data(), others.data(), values.data(),
                                values.data() + 9, values.data() + 18);
      break;
    case 6:
      hs_recording_set_bolts(recording, count, numbers.data(), values.data(), values.data() + 9,
                             values.data() + 18, wholes.data());
      break;
    case 7:
      hs_recording_add_cracks(recording, count, values.data(), numbers.data(), others.data(),
                              values.data() + 3, values.data() + 12, values.data() + 21, wholes.data());
      break;
    default:
      hs_recording_set_history(recording, "time,a\n0,1\n");
      break;
  }
}

void call_interface(Bytes& bytes) {
  hs_recording* recording = hs_recording_create(bytes.between(1, 4), "any calls");
  if (!recording) return;
  while (!bytes.empty()) call(bytes, recording);
  hs_recording_write(recording, viewer_page().c_str(), "/dev/null");
  hs_recording_destroy(recording);
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfspace_fuzz;
  Bytes bytes(data, size);
  constexpr void (*targets[])(Bytes&) = {read_made_run, read_damaged_run, call_interface};
  targets[bytes.below(3)](bytes);
  return 0;
}
