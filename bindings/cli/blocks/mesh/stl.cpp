#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <map>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {
namespace {

using Triangle = std::array<Point, 3>;

/// Adds triangles to a surface, with one vertex for all coincident corners of an object.
class Welder {
 public:
  explicit Welder(Surface& surface) : surface_(surface) {}

  void begin_object() {
    vertices_.clear();
    ++object_;
  }

  void add(const Triangle& corners, int number) {
    Surface::Face face{.vertices = {}, .object = object_, .number = number};
    for (const Point& corner : corners) face.vertices.push_back(vertex_at(corner));
    const auto& v = face.vertices;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      throw MeshFault(surface_.place(face), "a triangle with two corners at the same place");
    surface_.faces.push_back(std::move(face));
  }

 private:
  int vertex_at(const Point& corner) {
    const auto [entry, is_new] = vertices_.emplace(corner, static_cast<int>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(corner);
    return entry->second;
  }

  Surface& surface_;
  std::map<Point, int> vertices_;
  int object_ = 0;
};

// A binary file: 80 bytes of anything, the number of triangles, and 50 bytes for each.
constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;

/// A little-endian number.
std::uint32_t stored_number(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Decided by the length alone: the header of a binary file may begin with "solid" like a text.
bool is_binary(const std::string& content) {
  return content.size() >= header_size &&
         content.size() == header_size + record_size * std::size_t{stored_number(content.data() + 80)};
}

/// The spacing of numbers in single precision at the largest coordinate.
double last_digit_of_floats(const std::vector<Point>& vertices) {
  double largest = 0;
  for (const Point& vertex : vertices) {
    for (const double coordinate : vertex) largest = std::max(largest, std::abs(coordinate));
  }
  return largest > 0 ? std::ldexp(1, std::ilogb(largest) - 23) : 0;
}

Surface read_binary(const std::string& name, const std::string& content) {
  Surface surface;
  surface.file = name;
  surface.separator = ": triangle ";
  Welder welder(surface);
  for (std::size_t i = 0; header_size + i * record_size < content.size(); ++i) {
    const char* numbers = content.data() + header_size + i * record_size + 12;  // after the normal
    Triangle corners;
    for (Point& corner : corners) {
      for (double& coordinate : corner) {
        coordinate = std::bit_cast<float>(stored_number(numbers));
        numbers += 4;
        if (!std::isfinite(coordinate))
          throw MeshFault(name + ": triangle " + std::to_string(i + 1), "a coordinate that is not finite");
      }
    }
    welder.add(corners, static_cast<int>(i + 1));
  }
  surface.last_digit = last_digit_of_floats(surface.vertices);
  return surface;
}

/// True for the keyword, which some programs write in capitals.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char c, char of_keyword) {
    return std::tolower(static_cast<unsigned char>(c)) == of_keyword;
  });
}

void await(const TextLines& lines, std::string_view first, std::string_view second) {
  const auto& words = lines.words();
  if (words.size() > 1 && is_keyword(words[0], first) && is_keyword(words[1], second)) return;
  lines.fail("expected: \"" + std::string(first) + ' ' + std::string(second) + '"');
}

Triangle read_facet(TextLines& lines) {
  await(lines, "facet", "normal");
  lines.next("outer loop");
  await(lines, "outer", "loop");
  Triangle corners;
  for (Point& corner : corners) {
    lines.next("vertex");
    if (!is_keyword(lines.keyword(), "vertex")) lines.fail("expected: \"vertex\"; a facet has three");
    corner = lines.point(1);
  }
  for (std::string_view end : {"endloop", "endfacet"}) {
    lines.next(end);
    if (!is_keyword(lines.keyword(), end)) lines.fail("expected: \"" + std::string(end) + '"');
  }
  return corners;
}

Surface read_text(const std::string& name, const std::string& content) {
  Surface surface;
  surface.file = name;
  Welder welder(surface);
  TextLines lines(name, content, 0);
  while (lines.next()) {
    if (!is_keyword(lines.keyword(), "solid")) {
      lines.fail("expected: \"solid\", or a binary file of 84 bytes and 50 for each of its triangles");
    }
    welder.begin_object();
    for (lines.next("facet or endsolid"); !is_keyword(lines.keyword(), "endsolid");
         lines.next("facet or endsolid")) {
      const int first_line = lines.line();
      welder.add(read_facet(lines), first_line);
    }
  }
  surface.last_digit = lines.digits().last();
  return surface;
}

}  // namespace

Surface read_stl(const std::string& name, const std::string& content) {
  return is_binary(content) ? read_binary(name, content) : read_text(name, content);
}

}  // namespace halfspace::cli
