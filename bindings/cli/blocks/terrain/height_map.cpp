#include "blocks/terrain/height_map.h"

#include <png.h>

#include <algorithm>
#include <cstdint>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {

HeightMap read_csv_heights(const std::string& name, const std::string& content) {
  std::string numbers = content;
  std::replace_if(
      numbers.begin(), numbers.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  HeightMap map;
  TextLines lines(name, numbers, '#');
  while (lines.next()) {
    if (map.rows == 0) map.columns = lines.words().size();
    if (lines.words().size() != map.columns) {
      lines.fail("a row of " + std::to_string(lines.words().size()) + " heights; the first row has " +
                 std::to_string(map.columns));
    }
    for (std::size_t column = 0; column < map.columns; ++column) map.heights.push_back(lines.number(column));
    ++map.rows;
  }
  return map;
}

HeightMap read_png_heights(const std::string& name, const std::string& content) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto check = [&](int is_read) {
    if (is_read) return;
    const std::string text = image.message;
    png_image_free(&image);
    throw MeshFault(name, "not a PNG image: " + text);
  };
  check(png_image_begin_read_from_memory(&image, content.data(), content.size()));
  if (image.format & (PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA)) {
    png_image_free(&image);
    throw MeshFault(name, "an image with colours or transparency; allowed: grey, of 8 or 16 bits");
  }
  // Linear values have 16 bits; libpng converts images of 8 bits by a gamma curve, so these are read as they
  // are.
  const bool is_linear = (image.format & PNG_FORMAT_FLAG_LINEAR) != 0;
  HeightMap map{.columns = image.width, .rows = image.height, .heights = {}};
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
