#pragma once

#include <string>

#include "output/picture/canvas.h"

namespace halfspace::cli {

/// An image as the bytes of a PNG file. The same image gives the same bytes. @throws std::runtime_error
std::string png(const Image& image);

}  // namespace halfspace::cli
