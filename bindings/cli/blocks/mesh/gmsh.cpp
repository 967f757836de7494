#include "blocks/mesh/gmsh.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {
namespace {

class GmshReader {
 public:
  GmshReader(const std::string& name, const std::string& content) : lines_(name, content, 0) {
    file_.name = name;
  }

  GmshFile read() {
    lines_.next("$MeshFormat");
    if (lines_.keyword() != "$MeshFormat") lines_.fail("not a Gmsh file: it does not begin with $MeshFormat");
    read_format();
    while (lines_.next()) {
      const std::string section(lines_.keyword());
      if (section == "$Nodes" || section == "$ParametricNodes") {  // the latter in version 2.2
        is_new_ ? read_nodes_4() : read_nodes_2();
      } else if (section == "$Elements") {
        is_new_ ? read_elements_4() : read_elements_2();
      } else if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$PartitionedEntities") {
        lines_.fail("a mesh in partitions; allowed: a whole one");
      }
      skip_to_end_of(section);
    }
    file_.last_digit = lines_.digits().last();
    return std::move(file_);
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
    if (!section.starts_with('$')) lines_.fail("expected: a section, $...");
    const std::string end = "$End" + section.substr(1);
    const bool may_be_skipped =
        section != "$Nodes" && section != "$ParametricNodes" && section != "$Elements";
    for (lines_.next(end); lines_.keyword() != end; lines_.next(end)) {
      if (!may_be_skipped) lines_.fail("expected: " + end);
    }
  }

  /// Joins the words of a name by single blanks; consecutive blanks are lost.
  void read_names() {
    lines_.next("the number of names");
    const std::size_t count = lines_.count(0);
    for (std::size_t i = 0; i < count; ++i) {
      lines_.next("a name");
      std::string name;
      for (std::size_t word = 2; word < lines_.words().size(); ++word)
        name += (word > 2 ? " " : "") + std::string(lines_.words()[word]);
      if (name.size() < 2 || name.front() != '"' || name.back() != '"')
        lines_.fail("expected: dimension, number, and a name in quotes");
      names_[{lines_.integer(0), lines_.integer(1)}] = name.substr(1, name.size() - 2);
    }
  }

  /// Points list a position, other entities a bounding box; the physical groups follow.
  void read_entities() {
    lines_.next("the numbers of entities");
    std::array<std::size_t, 4> counts{};
    for (std::size_t dimension = 0; dimension < 4; ++dimension) counts[dimension] = lines_.count(dimension);
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      const std::size_t before_groups = dimension == 0 ? 4 : 7;
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        lines_.next("an entity");
        const std::int64_t tag = lines_.integer(0);
        std::vector<int>& groups = groups_of_entity_[{static_cast<std::int64_t>(dimension), tag}];
        const std::size_t count = lines_.count(before_groups);
        for (std::size_t k = 0; k < count; ++k)
          groups.push_back(
              group(static_cast<std::int64_t>(dimension), lines_.integer(before_groups + 1 + k)));
      }
    }
  }

  /// The index of a physical group; a negative number means reversed orientation.
  int group(std::int64_t dimension, std::int64_t number) {
    if (number == std::numeric_limits<std::int64_t>::min()) lines_.fail("a group without a number");
    const std::pair key{dimension, number < 0 ? -number : number};
    const auto [known, is_new] = groups_.emplace(key, static_cast<int>(file_.groups.size()));
    if (is_new) {
      const auto name = names_.find(key);
      file_.groups.push_back(name == names_.end() ? std::to_string(key.second) : name->second);
    }
    return known->second;
  }

  void read_nodes_2() {
    lines_.next("the number of nodes");
    const std::size_t count = lines_.count(0);
    for (std::size_t i = 0; i < count; ++i) {
      lines_.next("a node");
      const std::int64_t tag = lines_.integer(0);  // first, so that the first fault of the line is reported
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
    if (!nodes_.emplace(tag, static_cast<int>(file_.nodes.size())).second)
      lines_.fail("node " + std::to_string(tag) + " is defined twice");
    file_.nodes.push_back(place);
  }

  void read_elements_2() {
    lines_.next("the number of elements");
    const std::size_t count = lines_.count(0);
    for (std::size_t i = 0; i < count; ++i) {
      lines_.next("an element");
      const ElementForm& form = known_form(lines_.integer(1));
      const std::size_t tags = lines_.count(2);
      std::vector<int> groups;
      if (tags > 0 && lines_.integer(3) != 0) groups.push_back(group(form.dimension, lines_.integer(3)));
      add_element(form, 3 + tags, groups);
    }
  }

  void read_elements_4() {
    lines_.next("the number of blocks of elements");
    const std::size_t blocks = lines_.count(0);
    for (std::size_t block = 0; block < blocks; ++block) {
      lines_.next("a block of elements");
      const std::vector<int> groups = groups_of_entity_[{lines_.integer(0), lines_.integer(1)}];
      const ElementForm& form = known_form(lines_.integer(2));
      const std::size_t count = lines_.count(3);
      for (std::size_t i = 0; i < count; ++i) {
        lines_.next("an element");
        add_element(form, 1, groups);
      }
    }
  }

  const ElementForm& known_form(std::int64_t type) const {
    if (const ElementForm* form = form_of_type(type)) return *form;
    lines_.fail("an element of type " + std::to_string(type) +
                "; allowed: 4 (tetrahedron), 5 (hexahedron), 6 (prism), 7 (pyramid), and 15, 1, 2, 3, which "
                "are no blocks");
  }

  /// Adds the element of this line; `first_node` is the word of its first node.
  void add_element(const ElementForm& form, std::size_t first_node, const std::vector<int>& groups) {
    GmshFile::Element element{.form = &form, .nodes = {}, .groups = groups, .line = lines_.line()};
    for (std::size_t i = 0; i < form.node_count; ++i) {
      const std::int64_t tag = lines_.integer(first_node + i);
      const auto node = nodes_.find(tag);
      if (node == nodes_.end()) lines_.fail("no node " + std::to_string(tag));
      element.nodes.push_back(node->second);
    }
    file_.elements.push_back(std::move(element));
  }

  using Key = std::pair<std::int64_t, std::int64_t>;  ///< dimension and number

  TextLines lines_;
  bool is_new_ = false;  // 4.1, not 2.2
  GmshFile file_;
  std::unordered_map<std::int64_t, int> nodes_;
  std::map<Key, std::string> names_;
  std::map<Key, int> groups_;
  std::map<Key, std::vector<int>> groups_of_entity_;
};

}  // namespace

GmshFile read_gmsh(const std::string& name, const std::string& content) {
  return GmshReader(name, content).read();
}

std::vector<Solid> solids_of(const GmshFile& file) {
  std::vector<Solid> solids;
  for (const GmshFile::Element& element : file.elements) {
    if (element.form->dimension < 3) continue;
    Solid& solid = solids.emplace_back(Solid{.vertices = {},
                                             .faces = element.form->faces,
                                             .place = file.place(element),
                                             .last_digit = file.last_digit});
    for (const int node : element.nodes) solid.vertices.push_back(file.nodes[static_cast<std::size_t>(node)]);
  }
  if (solids.empty()) {
    throw MeshFault(file.name, "no element with a volume; allowed: tetrahedra, hexahedra, prisms, pyramids");
  }
  return solids;
}

}  // namespace halfspace::cli
