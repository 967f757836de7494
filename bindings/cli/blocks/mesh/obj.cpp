#include <algorithm>

#include "blocks/mesh/surface.h"
#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {
namespace {

/// A corner is vertex, vertex/texture, vertex//normal or vertex/texture/normal. Vertices count from 1, or
/// from -1 backwards from the last one before the face.
int vertex_of(const TextLines& lines, std::string_view corner, std::size_t vertex_count) {
  const std::int64_t number = lines.integer_of(corner.substr(0, corner.find('/')));
  const auto count = static_cast<std::int64_t>(vertex_count);
  const std::int64_t vertex = number < 0 ? count + number : number - 1;
  if (vertex < 0 || vertex >= count) {
    lines.fail("no vertex " + std::to_string(number) + "; there are " + std::to_string(count) + " before it");
  }
  return static_cast<int>(vertex);
}

}  // namespace

Surface read_obj(const std::string& name, const std::string& content) {
  static constexpr std::string_view looks[] = {"vn", "vt", "g", "s", "usemtl", "mtllib"};
  Surface surface;
  surface.file = name;
  TextLines lines(name, content, '#');
  int object = 0;
  while (lines.next()) {
    const std::string_view keyword = lines.keyword();
    if (keyword == "v") {
      surface.vertices.push_back(lines.point(1));
    } else if (keyword == "f") {
      if (lines.words().size() < 4) lines.fail("a face of fewer than 3 vertices");
      Surface::Face face{.vertices = {}, .object = object, .number = lines.line()};
      for (std::size_t i = 1; i < lines.words().size(); ++i)
        face.vertices.push_back(vertex_of(lines, lines.words()[i], surface.vertices.size()));
      surface.faces.push_back(std::move(face));
    } else if (keyword == "o") {
      ++object;
    } else if (std::find(std::begin(looks), std::end(looks), keyword) == std::end(looks)) {
      lines.fail("unknown: \"" + std::string(keyword) + "\"; allowed: v, f, o, vn, vt, g, s, usemtl, mtllib");
    }
  }
  surface.last_digit = lines.digits().last();
  return surface;
}

}  // namespace halfspace::cli
