#include "output/picture/png.h"

#include <png.h>

#include <stdexcept>

namespace halfspace::cli {

std::string png(const Image& image) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width);
  description.height = static_cast<png_uint_32>(image.height);
  description.format = PNG_FORMAT_RGB;
  const auto write = [&](void* memory, png_alloc_size_t& size) {
    if (!png_image_write_to_memory(&description, memory, &size, 0, image.bytes.data(), 0, nullptr))
      throw std::runtime_error(std::string("cannot write a PNG image: ") + description.message);
  };
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(description);
  std::string bytes(size, '\0');
  write(bytes.data(), size);
  bytes.resize(size);
  return bytes;
}

}  // namespace halfspace::cli
