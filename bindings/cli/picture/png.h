#pragma once

#include <string>

#include "picture/canvas.h"

namespace halfspace::cli {

/// An image as the bytes of a PNG file. The same image gives the same bytes. @throws std::runtime_error
std::string png(const Image& image);

/// Bytes as text (RFC 4648), so that they can stand in an SVG file.
std::string base64(const std::string& bytes);

}  // namespace halfspace::cli
