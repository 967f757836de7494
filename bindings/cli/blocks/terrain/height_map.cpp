#include "blocks/terrain/height_map.h"

#include <png.h>

#include <cstdint>
#include <memory>

#include "blocks/mesh/mesh_fault.h"
#include "scene/scene.h"

namespace halfspace::cli {
namespace {

/// Refuses an image by what its header says, before memory is taken: more pixels than the file can hold, as
/// DEFLATE packs at most 1032 bytes into one, or more triangles than a scene has blocks.
void require_size(const std::string& name, const std::string& content, const png_image& image) {
  constexpr std::size_t place_of_bit_depth = 24, max_ratio = 1032;
  const auto bit_depth = static_cast<unsigned char>(content[place_of_bit_depth]);
  const std::uint64_t columns = image.width, rows = image.height;
  const std::uint64_t bytes = rows * (1 + (columns * bit_depth + 7) / 8);  // each row begins with its filter
  const std::string size = std::to_string(columns) + " x " + std::to_string(rows) + " pixels";
  if (bytes > max_ratio * content.size())
    throw MeshFault(name,
                    size + ", more than a file of " + std::to_string(content.size()) + " bytes can hold");
  if (columns * rows > static_cast<std::uint64_t>(max_blocks / 2))
    throw MeshFault(
        name, size + ", with two triangles each; allowed: at most " + std::to_string(max_blocks) + " blocks");
}

}  // namespace

HeightMap read_png_heights(const std::string& name, const std::string& content) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&image, png_image_free);
  const auto check = [&](int is_read) {
    if (!is_read) throw MeshFault(name, "not a PNG image: " + std::string(image.message));
  };
  check(png_image_begin_read_from_memory(&image, content.data(), content.size()));
  if (image.format & (PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA))
    throw MeshFault(name, "an image with colours or transparency; allowed: grey, of 8 or 16 bits");
  require_size(name, content, image);
  // Linear values have 16 bits; libpng converts images of 8 bits by a gamma curve, so these are read as they
  // are.
  const bool is_linear = (image.format & PNG_FORMAT_FLAG_LINEAR) != 0;
  HeightMap map{.columns = image.width, .rows = image.height};
  const auto read = [&](auto& values, std::uint32_t format, double white) {
    image.format = format;
    values.resize(map.columns * map.rows);
    check(png_image_finish_read(&image, nullptr, values.data(), 0, nullptr));
    for (const auto value : values) map.heights.push_back(value / white);
  };
  std::vector<std::uint16_t> of_16_bits;
  std::vector<std::uint8_t> of_8_bits;
  if (is_linear) {
    read(of_16_bits, PNG_FORMAT_LINEAR_Y, 65535);
  } else {
    read(of_8_bits, PNG_FORMAT_GRAY, 255);
  }
  return map;
}

}  // namespace halfspace::cli
