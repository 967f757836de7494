#include "blocks/mesh/surface.h"
#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {

Surface read_off(const std::string& name, const std::string& content) {
  Surface surface;
  surface.file = name;
  TextLines lines(name, content, '#');
  lines.next("OFF");
  if (lines.keyword() != "OFF") lines.fail("not an OFF file: it does not begin with OFF");
  std::size_t first = 1;  // the counts may follow on the same line
  if (lines.words().size() == 1) {
    lines.next("the numbers of vertices, faces and edges");
    first = 0;
  }
  const std::size_t vertex_count = lines.count(first);
  const std::size_t face_count = lines.count(first + 1);

  for (std::size_t i = 0; i < vertex_count; ++i) {
    lines.next("vertex " + std::to_string(i) + " of " + std::to_string(vertex_count));
    surface.vertices.push_back(lines.point(0));
  }
  for (std::size_t i = 0; i < face_count; ++i) {
    lines.next("face " + std::to_string(i) + " of " + std::to_string(face_count));
    const std::size_t corners = lines.count(0);
    if (corners < 3) lines.fail("a face of fewer than 3 vertices");
    Surface::Face face{.vertices = {}, .object = 0, .number = lines.line()};
    for (std::size_t k = 1; k <= corners; ++k) {
      const std::int64_t vertex = lines.integer(k);
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count) {
        lines.fail("no vertex " + std::to_string(vertex) + "; there are " + std::to_string(vertex_count) +
                   ", counted from 0");
      }
      face.vertices.push_back(static_cast<int>(vertex));
    }
    surface.faces.push_back(std::move(face));
  }
  if (lines.next()) lines.fail("more than the " + std::to_string(face_count) + " faces announced");
  surface.last_digit = lines.digits().last();
  return surface;
}

}  // namespace halfspace::cli
