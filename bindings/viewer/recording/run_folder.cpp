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
  std::size_t first_cell = 0, end_cell = 0;
  std::size_t first_point = 0, end_point = 0;
};

/// The blocks of a frame, in ascending order, each with points of its own.
std::vector<BlockPart> parts_of(const VtkFrame& frame) {
  std::vector<BlockPart> parts;
  for (std::size_t c = 0; c < frame.cell_count(); ++c) {
    const std::size_t number = frame.index("block", c);
    const std::vector<std::size_t> points = frame.cell(c);
    if (points.empty()) throw std::runtime_error(frame.file() + ": a face has no vertices");
    const auto [low, high] = std::minmax_element(points.begin(), points.end());
    if (parts.empty() || parts.back().number != number)
      parts.push_back({.number = number, .first_cell = c, .first_point = *low});
    BlockPart& part = parts.back();
    part.end_cell = c + 1;
    part.first_point = std::min(part.first_point, *low);
    part.end_point = std::max(part.end_point, *high + 1);
  }
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (parts[i].number < parts[i - 1].number || parts[i].first_point < parts[i - 1].end_point)
      throw std::runtime_error(frame.file() + ": its blocks are not in order at block " +
                               std::to_string(parts[i].number));
  return parts;
}

std::vector<Point> vertices_of(const VtkFrame& frame, const BlockPart& part) {
  const auto at = [&](std::size_t point) {
    return frame.points().begin() + static_cast<std::ptrdiff_t>(point);
  };
  return {at(part.first_point), at(part.end_point)};
}

/// A point of a cell that has at least so many.
Point point_of(const VtkFrame& frame, std::size_t cell, std::size_t index) {
  const std::vector<std::size_t> points = frame.cell(cell);
  if (index >= points.size())
    throw std::runtime_error(frame.file() + ": cell " + std::to_string(cell) + " has " +
                             std::to_string(points.size()) + " points");
  return frame.points()[points[index]];
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
  Reader(const RunFiles& files, const std::string& folder) : files_(files), folder_(folder) {}

  Recording read() {
    const auto frames = collection("run.pvd");
    if (frames.empty()) throw std::runtime_error(path_of("run.pvd") + " has no frames");
    const VtkFrame start = frame(frames[0].second);
    Recording recording(start.has("angle") ? 2 : 3, title());
    const auto terrains = collection("terrain.pvd");
    read_blocks(start, recording);
    if (!terrains.empty()) add_blocks(frame(terrains[0].second), true, recording);
    const auto contacts = collection("contacts.pvd"), bolts = collection("bolts.pvd"),
               waters = collection("water.pvd");
    auto next_terrain = terrains.begin();
    for (std::size_t f = 0; f < frames.size(); ++f) {
      recording.add_frame(frames[f].first);
      add_motion(frame(frames[f].second), recording);
      for (; next_terrain != terrains.end() && next_terrain->first <= frames[f].first; ++next_terrain)
        remove_missing(frame(next_terrain->second), recording);
      if (f < contacts.size()) add_contacts(frame(contacts[f].second), recording);
      if (f < bolts.size()) add_bolts(frame(bolts[f].second), recording);
      if (f < waters.size()) set_water(frame(waters[f].second), recording);
    }
    read_cracks(recording);
    if (const auto history = files_("history.csv")) recording.set_history(*history);
    return recording;
  }

 private:
  std::string path_of(const std::string& name) const { return (fs::path(folder_) / name).string(); }

  VtkFrame frame(const std::string& name) const {
    const std::optional<std::string> content = files_(name);
    if (!content) throw std::runtime_error("cannot read " + path_of(name));
    return VtkFrame(*content, path_of(name));
  }

  std::vector<std::pair<double, std::string>> collection(const char* name) const {
    return read_collection(files_(name).value_or(""));
  }

  Csv table(const char* name) const { return Csv(files_(name).value_or("")); }

  /// The title of the scene, which the summary begins with, or the name of the folder.
  std::string title() const {
    const std::string begin = "scene ";
    const std::string text = files_("summary.txt").value_or("");
    const std::string line = text.substr(0, text.find('\n'));
    const std::size_t place = line.find_first_not_of(' ', begin.size());
    return line.starts_with(begin) && place != std::string::npos ? line.substr(place)
                                                                 : fs::path(folder_).filename().string();
  }

  void read_blocks(const VtkFrame& start, Recording& recording) {
    std::vector<std::string> materials(max_materials);
    const Csv blocks = table("blocks.csv");
    for (std::size_t row = 0; row < blocks.row_count(); ++row) {
      names_.push_back(blocks.text(row, "name"));
      number_of_name_.emplace(names_.back(), row);
      const double material = blocks.number(row, "material_number");
      if (material >= 0 && material < max_materials)
        materials[static_cast<std::size_t>(material)] = blocks.text(row, "material");
    }
    while (!materials.empty() && materials.back().empty()) materials.pop_back();
    recording.set_material_names(materials);
    add_blocks(start, false, recording);
  }

  void add_blocks(const VtkFrame& start, bool are_still, Recording& recording) {
    for (const BlockPart& part : parts_of(start)) {
      if (part.number > std::max(recording.block_count(), names_.size()))
        throw std::runtime_error(start.file() +
                                 " has a block that blocks.csv is without: " + std::to_string(part.number));
      // Blocks that the first frame is without keep their numbers, and have no vertices.
      while (recording.block_count() < part.number) {
        BlockShape missing{.name = name_of(recording.block_count())};
        if (are_still)
          recording.add_still_block(std::move(missing));
        else
          recording.add_block(std::move(missing), {});
      }
      if (recording.block_count() != part.number)
        throw std::runtime_error(start.file() +
                                 " has a block that is recorded already: " + std::to_string(part.number));
      add_block(start, part, are_still, recording);
    }
  }

  /// Removes the still blocks that a frame of the terrain is without.
  static void remove_missing(const VtkFrame& terrain, Recording& recording) {
    std::vector<bool> is_there(recording.block_count());
    for (const BlockPart& part : parts_of(terrain)) is_there[known(terrain, part.number, recording)] = true;
    for (std::size_t block = recording.block_count(); block-- > 0 && recording.is_still(block);)
      if (!is_there[block]) recording.remove_still_block(block);
  }

  /// A number in a frame. @throws std::runtime_error if the recording has no such block
  static std::size_t known(const VtkFrame& frame, std::size_t block, const Recording& recording) {
    if (block >= recording.block_count())
      throw std::runtime_error(frame.file() +
                               " has a block that the first frame is without: " + std::to_string(block));
    return block;
  }

  std::string name_of(std::size_t block) const {
    return block < names_.size() ? names_[block] : std::string();
  }

  void add_block(const VtkFrame& start, const BlockPart& part, bool is_still, Recording& recording) {
    BlockShape shape{.name = name_of(part.number),
                     .kind = static_cast<int>(start.index("kind", part.first_cell)),
                     .material = static_cast<int>(start.index("material", part.first_cell)),
                     .vertices = vertices_of(start, part)};
    for (std::size_t c = part.first_cell; c < part.end_cell; ++c) {
      std::vector<int>& face = shape.faces.emplace_back();
      for (const std::size_t point : start.cell(c))
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
      recording.set_vertices(known(frame, part.number, recording), vertices_of(frame, part),
                             rotation_of(frame, part.first_cell));
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
      contacts.push_back({.block_a = known(frame, frame.index("block_a", c), recording),
                          .block_b = known(frame, frame.index("block_b", c), recording),
                          .point = point_of(frame, c, 0),
                          .force = frame.vector("force", c),
                          .normal_force = frame.value("normal_force", c)});
    recording.set_contacts(std::move(contacts));
  }

  static void add_bolts(const VtkFrame& frame, Recording& recording) {
    for (std::size_t c = 0; c < frame.cell_count(); ++c)
      recording.set_bolt({.number = frame.index("bolt", c),
                          .place_a = point_of(frame, c, 0),
                          .place_b = point_of(frame, c, 1),
                          .tension = frame.value("tension", c),
                          .is_ruptured = frame.value("is_ruptured", c) != 0});
  }

  static void set_water(const VtkFrame& frame, Recording& recording) {
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t c = 0; c < frame.cell_count(); ++c) faces.push_back(frame.cell(c));
    recording.set_water(frame.points(), std::move(faces));
  }

  void read_cracks(Recording& recording) const {
    const Csv cracks = table("cracks.csv");
    const auto is_recorded = [&](const auto& named) {
      return named != number_of_name_.end() && named->second < recording.block_count();
    };
    for (std::size_t row = 0; row < cracks.row_count(); ++row) {
      const auto block_a = number_of_name_.find(cracks.text(row, "block_a"));
      const auto block_b = number_of_name_.find(cracks.text(row, "block_b"));
      if (!is_recorded(block_a) || !is_recorded(block_b)) continue;
      recording.add_crack(
          {.time = cracks.number(row, "time"),
           .blocks = {block_a->second, block_b->second},
           .position = {cracks.number(row, "x"), cracks.number(row, "y"), cracks.number(row, "z")},
           .normal = {cracks.number(row, "normal_x"), cracks.number(row, "normal_y"),
                      cracks.number(row, "normal_z")},
           .area = cracks.number(row, "area"),
           .is_shear = cracks.text(row, "failure") == "shear"});
    }
  }

  const RunFiles& files_;
  std::string folder_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> number_of_name_;
};

}  // namespace

Recording read_run(const RunFiles& files, const std::string& folder) { return Reader(files, folder).read(); }

Recording read_run(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error("there is no directory " + folder);
  if (!fs::exists(fs::path(folder) / "run.pvd"))
    throw std::runtime_error(folder + " has no run.pvd; it must be the output directory of `halfspace run`");
  const fs::path whole = fs::weakly_canonical(folder);
  const RunFiles files = [&](const std::string& name) -> std::optional<std::string> {
    if (!fs::exists(whole / name)) return std::nullopt;
    return bytes_of((whole / name).string());
  };
  return read_run(files, whole.string());
}

}  // namespace halfspace::viewer
