#include "recording/run_folder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "recording/bytes.h"
#include "recording/centroid.h"
#include "recording/csv.h"
#include "recording/vtk_frame.h"

namespace halfspace::viewer {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_materials = 4096;

/// The part of a frame that is one block: its cells and its points, both consecutive.
struct BlockPart {
  std::size_t number = 0;
  std::size_t first_cell = 0, cell_count = 0;
  std::size_t first_point = 0, point_count = 0;
};

std::vector<BlockPart> parts_of(const VtkFrame& frame) {
  std::vector<BlockPart> parts;
  for (std::size_t c = 0; c < frame.cell_count(); ++c) {
    const std::size_t number = frame.index("block", c);
    const std::vector<std::size_t> points = frame.cell(c);
    if (points.empty()) continue;
    const auto [low, high] = std::minmax_element(points.begin(), points.end());
    if (parts.empty() || parts.back().number != number)
      parts.push_back({.number = number, .first_cell = c, .first_point = *low});
    BlockPart& part = parts.back();
    ++part.cell_count;
    part.first_point = std::min(part.first_point, *low);
    part.point_count = std::max(part.point_count, *high + 1 - part.first_point);
  }
  return parts;
}

std::vector<Point> vertices_of(const VtkFrame& frame, const BlockPart& part) {
  const auto begin = frame.points().begin() + static_cast<std::ptrdiff_t>(part.first_point);
  return {begin, begin + static_cast<std::ptrdiff_t>(part.point_count)};
}

Quaternion rotation_of(const VtkFrame& frame, std::size_t cell) {
  if (frame.has("angle")) {
    const double half = frame.value("angle", cell) / 2;
    return {0, 0, std::sin(half), std::cos(half)};
  }
  return {frame.value("rotation", cell, 0), frame.value("rotation", cell, 1),
          frame.value("rotation", cell, 2), frame.value("rotation", cell, 3)};
}

double length_of(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

/// Components of a symmetric tensor that is stored row by row.
struct Component {
  const char* name;
  std::size_t place;
};

std::vector<Component> components_of(int dimension) {
  if (dimension == 2) return {{"xx", 0}, {"yy", 4}, {"xy", 1}};
  return {{"xx", 0}, {"yy", 4}, {"zz", 8}, {"yz", 5}, {"zx", 2}, {"xy", 1}};
}

class Reader {
 public:
  explicit Reader(const std::string& folder) : folder_(folder) {}

  Recording read() {
    const auto frames = collection("run.pvd");
    if (frames.empty()) throw std::runtime_error((folder_ / "run.pvd").string() + " has no frames");
    const VtkFrame start((folder_ / frames[0].second).string());
    Recording recording(start.has("angle") ? 2 : 3, title());
    const auto terrains = collection("terrain.pvd");
    read_blocks(start, recording);
    if (!terrains.empty()) add_blocks(VtkFrame((folder_ / terrains[0].second).string()), true, recording);
    const auto contacts = collection("contacts.pvd"), bolts = collection("bolts.pvd"),
               waters = collection("water.pvd");
    auto next_terrain = terrains.begin();
    for (std::size_t f = 0; f < frames.size(); ++f) {
      recording.add_frame(frames[f].first);
      add_motion(VtkFrame((folder_ / frames[f].second).string()), recording);
      for (; next_terrain != terrains.end() && next_terrain->first <= frames[f].first; ++next_terrain)
        remove_missing(VtkFrame((folder_ / next_terrain->second).string()), recording);
      if (f < contacts.size()) add_contacts(VtkFrame((folder_ / contacts[f].second).string()), recording);
      if (f < bolts.size()) add_bolts(VtkFrame((folder_ / bolts[f].second).string()), recording);
      if (f < waters.size()) set_water(VtkFrame((folder_ / waters[f].second).string()), recording);
    }
    read_cracks(recording);
    if (fs::exists(folder_ / "history.csv"))
      recording.set_history(bytes_of((folder_ / "history.csv").string()));
    return recording;
  }

 private:
  std::vector<std::pair<double, std::string>> collection(const char* name) const {
    if (std::string(name) != "run.pvd" && !fs::exists(folder_ / name)) return {};
    return read_collection((folder_ / name).string());
  }

  /// The title of the scene, which the summary begins with, or the name of the folder.
  std::string title() const {
    const std::string begin = "scene ";
    const fs::path summary = folder_ / "summary.txt";
    if (!fs::exists(summary)) return folder_.filename().string();
    const std::string text = bytes_of(summary.string());
    const std::string line = text.substr(0, text.find('\n'));
    const std::size_t place = line.find_first_not_of(' ', begin.size());
    return line.starts_with(begin) && place != std::string::npos ? line.substr(place)
                                                                 : folder_.filename().string();
  }

  void read_blocks(const VtkFrame& start, Recording& recording) {
    std::vector<std::string> materials(max_materials);
    if (fs::exists(folder_ / "blocks.csv")) {
      const Csv table(bytes_of((folder_ / "blocks.csv").string()));
      for (std::size_t row = 0; row < table.row_count(); ++row) {
        names_.push_back(table.text(row, "name"));
        number_of_name_.emplace(names_.back(), row);
        const double material = table.number(row, "material_number");
        if (material >= 0 && material < max_materials)
          materials[static_cast<std::size_t>(material)] = table.text(row, "material");
      }
    }
    while (!materials.empty() && materials.back().empty()) materials.pop_back();
    recording.set_material_names(materials);
    add_blocks(start, false, recording);
  }

  void add_blocks(const VtkFrame& start, bool are_still, Recording& recording) {
    for (const BlockPart& part : parts_of(start)) {
      // Blocks that the first frame is without keep their numbers, and have no vertices.
      while (recording.block_count() < part.number) {
        BlockShape missing{.name = name_of(recording.block_count())};
        if (are_still)
          recording.add_still_block(std::move(missing));
        else
          recording.add_block(std::move(missing), {});
      }
      if (recording.block_count() != part.number)
        throw std::runtime_error("the blocks of the first frame are not in order");
      add_block(start, part, are_still, recording);
    }
  }

  /// Removes the still blocks that a frame of the terrain is without.
  static void remove_missing(const VtkFrame& terrain, Recording& recording) {
    std::vector<bool> is_there(recording.block_count());
    for (const BlockPart& part : parts_of(terrain)) is_there.at(part.number) = true;
    for (std::size_t block = recording.block_count(); block-- > 0 && recording.is_still(block);)
      if (!is_there[block]) recording.remove_still_block(block);
  }

  std::string name_of(std::size_t block) const {
    return block < names_.size() ? names_[block] : std::string();
  }

  void add_block(const VtkFrame& start, const BlockPart& part, bool is_still, Recording& recording) {
    BlockShape shape{.name = name_of(part.number),
                     .kind = static_cast<int>(start.value("kind", part.first_cell)),
                     .material = static_cast<int>(start.value("material", part.first_cell)),
                     .vertices = vertices_of(start, part)};
    for (std::size_t c = 0; c < part.cell_count; ++c) {
      std::vector<int>& face = shape.faces.emplace_back();
      for (const std::size_t point : start.cell(part.first_cell + c))
        face.push_back(static_cast<int>(point - part.first_point));
    }
    if (is_still) {
      recording.add_still_block(std::move(shape));
      return;
    }
    const bool deforms = viewer::deforms(shape);
    const Pose pose{centroid_of(shape.vertices, shape.faces, recording.dimension()),
                    deforms ? Quaternion{0, 0, 0, 1} : rotation_of(start, part.first_cell)};
    recording.add_block(std::move(shape), pose);
  }

  void add_motion(const VtkFrame& frame, Recording& recording) {
    for (const BlockPart& part : parts_of(frame)) {
      if (part.number >= recording.block_count())
        throw std::runtime_error("a frame has a block that the first one is without: " +
                                 std::to_string(part.number));
      recording.set_vertices(part.number, vertices_of(frame, part), rotation_of(frame, part.first_cell));
      const auto set = [&](const char* name, const char* unit, double value) {
        recording.set_value(name, unit, part.number, value);
      };
      const std::size_t cell = part.first_cell;
      set("speed", "m/s", length_of(frame.vector("velocity", cell)));
      set("angular speed", "rad/s",
          frame.has("angle") ? std::abs(frame.value("angular_velocity", cell))
                             : length_of(frame.vector("angular_velocity", cell)));
      set("contact force", "N", length_of(frame.vector("contact_force", cell)));
      for (const char* tensor : {"stress", "strain"}) {
        if (!frame.has(tensor)) continue;
        for (const Component& component : components_of(recording.dimension()))
          recording.set_value(std::string(tensor) + ' ' + component.name, tensor[3] == 'e' ? "Pa" : "",
                              part.number, frame.value(tensor, cell, component.place));
      }
    }
  }

  static void add_contacts(const VtkFrame& frame, Recording& recording) {
    std::vector<ContactForce> contacts;
    for (std::size_t c = 0; c < frame.cell_count(); ++c)
      contacts.push_back({.block_a = frame.index("block_a", c),
                          .block_b = frame.index("block_b", c),
                          .point = frame.points()[frame.cell(c).at(0)],
                          .force = frame.vector("force", c),
                          .normal_force = frame.value("normal_force", c)});
    recording.set_contacts(std::move(contacts));
  }

  static void add_bolts(const VtkFrame& frame, Recording& recording) {
    for (std::size_t c = 0; c < frame.cell_count(); ++c)
      recording.set_bolt({.number = frame.index("bolt", c),
                          .place_a = frame.points()[frame.cell(c).at(0)],
                          .place_b = frame.points()[frame.cell(c).at(1)],
                          .tension = frame.value("tension", c),
                          .is_ruptured = frame.value("is_ruptured", c) != 0});
  }

  static void set_water(const VtkFrame& frame, Recording& recording) {
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t c = 0; c < frame.cell_count(); ++c) faces.push_back(frame.cell(c));
    recording.set_water(frame.points(), std::move(faces));
  }

  void read_cracks(Recording& recording) const {
    if (!fs::exists(folder_ / "cracks.csv")) return;
    const Csv table(bytes_of((folder_ / "cracks.csv").string()));
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const auto block_a = number_of_name_.find(table.text(row, "block_a"));
      const auto block_b = number_of_name_.find(table.text(row, "block_b"));
      if (block_a == number_of_name_.end() || block_b == number_of_name_.end()) continue;
      recording.add_crack(
          {.time = table.number(row, "time"),
           .blocks = {block_a->second, block_b->second},
           .position = {table.number(row, "x"), table.number(row, "y"), table.number(row, "z")},
           .normal = {table.number(row, "normal_x"), table.number(row, "normal_y"),
                      table.number(row, "normal_z")},
           .area = table.number(row, "area"),
           .is_shear = table.text(row, "failure") == "shear"});
    }
  }

  fs::path folder_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> number_of_name_;
};

}  // namespace

Recording read_run(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error("there is no directory " + folder);
  if (!fs::exists(fs::path(folder) / "run.pvd"))
    throw std::runtime_error(folder + " has no run.pvd; it must be the output directory of `halfspace run`");
  return Reader(fs::weakly_canonical(folder).string()).read();
}

}  // namespace halfspace::viewer
