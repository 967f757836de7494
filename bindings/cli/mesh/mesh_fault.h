#pragma once

#include <stdexcept>
#include <string>

namespace halfspace::cli {

/// What is wrong with a file of blocks, and where: "rocks.obj:12", "rocks.stl: triangle 7" or the name alone.
class MeshFault : public std::runtime_error {
 public:
  MeshFault(const std::string& place, const std::string& text) : std::runtime_error(place + ": " + text) {}
};

}  // namespace halfspace::cli
