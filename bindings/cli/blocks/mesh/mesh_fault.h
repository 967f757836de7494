#pragma once

#include <stdexcept>
#include <string>

namespace halfspace::cli {

/// A fault of a mesh file, with its place: "rocks.obj:12", "rocks.stl: triangle 7" or the name alone.
class MeshFault : public std::runtime_error {
 public:
  MeshFault(const std::string& place, const std::string& text) : std::runtime_error(place + ": " + text) {}
};

}  // namespace halfspace::cli
