#include "mesh/gmsh.h"

#include <algorithm>
#include <unordered_map>

#include "mesh/mesh_fault.h"
#include "mesh/text_lines.h"

namespace halfspace::cli {
namespace {

/// A kind of element with a volume: its number in the format, and its faces, seen from outside.
struct Kind {
  int number;
  std::size_t vertex_count;
  std::vector<std::vector<int>> faces;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {4, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
      {5, 8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
      {6, 6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {7, 5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
  return all;
}

/// Points, lines, triangles and quadrangles with straight sides.
constexpr std::int64_t flat_kinds[] = {1, 2, 3, 15};

class Reader {
 public:
  Reader(const std::string& name, const std::string& content) : lines_(name, content, 0) {}

  std::vector<Solid> read() {
    lines_.next("$MeshFormat");
    if (lines_.keyword() != "$MeshFormat") lines_.fail("not a Gmsh file: it does not begin with $MeshFormat");
    read_format();
    while (lines_.next()) {
      const std::string section(lines_.keyword());
      if (section == "$Nodes") {
        is_new_ ? read_nodes_4() : read_nodes_2();
      } else if (section == "$Elements") {
        is_new_ ? read_elements_4() : read_elements_2();
      }
      skip_to_end_of(section);
    }
    if (solids_.empty())
      lines_.fail("no element with a volume; allowed: tetrahedra, hexahedra, prisms, pyramids");
    return std::move(solids_);
  }

 private:
  void read_format() {
    lines_.next("version, file type and data size");
    const std::string_view version = lines_.words().front();
    if (version != "2.2" && version != "4.1")
      lines_.fail("version " + std::string(version) + "; allowed: 2.2 and 4.1");
    if (lines_.integer(1) != 0) lines_.fail("a binary file; allowed: text (Mesh.Binary = 0)");
    is_new_ = version == "4.1";
    skip_to_end_of("$MeshFormat");
  }

  void skip_to_end_of(const std::string& section) {
    if (!section.starts_with('$')) lines_.fail("awaited: a section, $...");
    const std::string end = "$End" + section.substr(1);
    const bool may_be_skipped = section != "$Nodes" && section != "$Elements";
    for (lines_.next(end); lines_.keyword() != end; lines_.next(end)) {
      if (!may_be_skipped) lines_.fail("awaited: " + end);
    }
  }

  void read_nodes_2() {
    lines_.next("the number of nodes");
    const std::size_t count = lines_.count(0);
    for (std::size_t i = 0; i < count; ++i) {
      lines_.next("a node");
      const std::int64_t tag = lines_.integer(0);  // first: the fault told is the first on the line
      add_node(tag, lines_.point(1));
    }
  }

  void read_nodes_4() {
    lines_.next("the number of blocks of nodes");
    const std::size_t blocks = lines_.count(0);
    for (std::size_t block = 0; block < blocks; ++block) {
      lines_.next("a block of nodes");
      std::vector<std::int64_t> tags(lines_.count(3));
      for (std::int64_t& tag : tags) {
        lines_.next("the tag of a node");
        tag = lines_.integer(0);
      }
      for (std::int64_t tag : tags) {
        lines_.next("the coordinates of a node");
        add_node(tag, lines_.point(0));
      }
    }
  }

  void add_node(std::int64_t tag, const Point& place) {
    if (!nodes_.emplace(tag, place).second) lines_.fail("node " + std::to_string(tag) + " was given before");
  }

  void read_elements_2() {
    lines_.next("the number of elements");
    const std::size_t count = lines_.count(0);
    for (std::size_t i = 0; i < count; ++i) {
      lines_.next("an element");
      const std::int64_t kind = lines_.integer(1);
      add_element(kind, 3 + lines_.count(2));
    }
  }

  void read_elements_4() {
    lines_.next("the number of blocks of elements");
    const std::size_t blocks = lines_.count(0);
    for (std::size_t block = 0; block < blocks; ++block) {
      lines_.next("a block of elements");
      const std::int64_t kind = lines_.integer(2);
      const std::size_t count = lines_.count(3);
      for (std::size_t i = 0; i < count; ++i) {
        lines_.next("an element");
        add_element(kind, 1);
      }
    }
  }

  /// The element of this line, whose nodes begin at a word.
  void add_element(std::int64_t number, std::size_t first_node) {
    if (std::find(std::begin(flat_kinds), std::end(flat_kinds), number) != std::end(flat_kinds)) return;
    const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                   [number](const Kind& known) { return known.number == number; });
    if (kind == kinds().end()) {
      lines_.fail(
          "an element of type " + std::to_string(number) +
          "; allowed: 4 (tetrahedron), 5 (hexahedron), 6 (prism), 7 (pyramid), and 15, 1, 2, 3, which "
          "are no blocks");
    }
    Solid solid{.vertices = {}, .faces = kind->faces, .place = lines_.place()};
    for (std::size_t i = 0; i < kind->vertex_count; ++i) {
      const std::int64_t tag = lines_.integer(first_node + i);
      const auto node = nodes_.find(tag);
      if (node == nodes_.end()) lines_.fail("no node " + std::to_string(tag));
      solid.vertices.push_back(node->second);
    }
    solids_.push_back(std::move(solid));
  }

  TextLines lines_;
  bool is_new_ = false;  // 4.1, not 2.2
  std::unordered_map<std::int64_t, Point> nodes_;
  std::vector<Solid> solids_;
};

}  // namespace

std::vector<Solid> read_gmsh(const std::string& name, const std::string& content) {
  return Reader(name, content).read();
}

}  // namespace halfspace::cli
