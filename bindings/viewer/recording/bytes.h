#pragma once

#include <string>

namespace halfspace::viewer {

/// All bytes of a file. @throws std::runtime_error if it cannot be read
std::string bytes_of(const std::string& file);

/// Writes a file. @throws std::runtime_error if that fails
void write_bytes(const std::string& file, const std::string& bytes);

}  // namespace halfspace::viewer
