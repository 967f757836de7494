#pragma once

#include <string>
#include <vector>

#include "blocks/mesh/solid.h"

namespace halfspace::cli {

/// Faces as a file lists them, of one or more solids.
struct Surface {
  struct Face {
    std::vector<int> vertices;
    int object;  ///< faces of different objects never belong together
    int number;  ///< for faults: the line it is on, or its number in a binary file
  };

  std::string file;
  std::string separator = ":";  ///< between file and number
  std::vector<Point> vertices;
  std::vector<Face> faces;
  double last_digit = 0;  ///< unit of the last digit of the coordinates

  std::string place(const Face& face) const { return file + separator + std::to_string(face.number); }
};

/// Wavefront OBJ: v, f and o (a new object); keywords of appearance are skipped.
Surface read_obj(const std::string& name, const std::string& content);

/// Object File Format: OFF, counts, vertices, faces; colours are skipped.
Surface read_off(const std::string& name, const std::string& content);

/// STL, text or binary. Coincident corners are one vertex, as the format has no shared vertices; each `solid`
/// of a text is an object.
Surface read_stl(const std::string& name, const std::string& content);

/// The connected parts of a surface, in the order of their first faces. Faces are connected by a common edge.
/// @throws MeshFault if the surface is not closed
std::vector<Solid> solids_of(const Surface& surface);

}  // namespace halfspace::cli
