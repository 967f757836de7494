#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "blocks/mesh/element_form.h"
#include "blocks/mesh/solid.h"

namespace halfspace::cli {

/// A Gmsh file, MSH 2.2 or 4.1 as text: points, lines, triangles, quadrangles, tetrahedra, hexahedra, prisms
/// and pyramids with straight sides.
struct GmshFile {
  struct Element {
    const ElementForm* form;
    std::vector<int> nodes;   ///< indices, in the order of the format
    std::vector<int> groups;  ///< indices of the physical groups that it is in
    int line;                 ///< in the file
  };
  std::string name;
  std::vector<Point> nodes;
  std::vector<Element> elements;
  double last_digit = 0;            ///< unit of the last digit of the coordinates
  std::vector<std::string> groups;  ///< names, or numbers of groups without a name

  std::string place(const Element& element) const { return name + ':' + std::to_string(element.line); }
};

/// @throws MeshFault
GmshFile read_gmsh(const std::string& name, const std::string& content);

/// A solid for each element with a volume; other elements are its boundary and are skipped.
/// @throws MeshFault if there is none
std::vector<Solid> solids_of(const GmshFile& file);

}  // namespace halfspace::cli
