#include "blocks/mesh/surface.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "blocks/mesh/mesh_fault.h"
#include "common/text.h"

namespace halfspace::cli {
namespace {

/// A directed edge of a face.
struct Side {
  int object;
  int from;
  int to;
  int face;

  auto key() const { return std::tie(object, from, to); }
  bool operator<(const Side& other) const {
    return std::tie(object, from, to, face) < std::tie(other.object, other.from, other.to, other.face);
  }
};

std::vector<Side> sides_of(const Surface& surface) {
  std::vector<Side> sides;
  for (std::size_t face = 0; face < surface.faces.size(); ++face) {
    const std::vector<int>& loop = surface.faces[face].vertices;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      sides.push_back(
          {surface.faces[face].object, loop[i], loop[(i + 1) % loop.size()], static_cast<int>(face)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

[[noreturn]] void fail(const Surface& surface, const Side& side, const std::string& text) {
  const auto at = [&](int vertex) { return described(surface.vertices[static_cast<std::size_t>(vertex)]); };
  throw MeshFault(surface.place(surface.faces[static_cast<std::size_t>(side.face)]),
                  "the edge from " + at(side.from) + " to " + at(side.to) + ' ' + text +
                      "; allowed: closed surfaces with consistently oriented faces");
}

/// Disjoint sets of connected faces.
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int face) {
    while (parent(face) != face) face = parent(face) = parent(parent(face));
    return face;
  }
  /// The set of the earlier face represents both.
  void join(int a, int b) {
    const auto [first, second] = std::minmax({of(a), of(b)});
    parent(second) = first;
  }

 private:
  int& parent(int face) { return parent_[static_cast<std::size_t>(face)]; }
  std::vector<int> parent_;
};

Parts connected_parts(const Surface& surface) {
  const std::vector<Side> sides = sides_of(surface);
  Parts parts(surface.faces.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i + 1 < sides.size() && sides[i + 1].key() == side.key())
      fail(surface, sides[i + 1], "is used twice in the same direction");
    const Side reverse{side.object, side.to, side.from, 0};
    const auto other = std::lower_bound(sides.begin(), sides.end(), reverse);
    if (other == sides.end() || other->key() != reverse.key())
      fail(surface, side, "has no face on its other side");
    parts.join(side.face, other->face);
  }
  return parts;
}

}  // namespace

std::vector<Solid> solids_of(const Surface& surface) {
  if (surface.faces.empty()) throw MeshFault(surface.file, "no faces; allowed: closed surfaces");
  Parts parts = connected_parts(surface);
  std::vector<Solid> solids;
  std::map<int, std::size_t> solid_of_part;
  std::vector<std::map<int, int>> numbers;  // of the surface's vertices in each solid
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    const auto [entry, is_new] = solid_of_part.emplace(parts.of(static_cast<int>(i)), solids.size());
    if (is_new) {
      solids.push_back({.vertices = {},
                        .faces = {},
                        .place = surface.place(surface.faces[i]),
                        .last_digit = surface.last_digit});
      numbers.emplace_back();
    }
    Solid& solid = solids[entry->second];
    std::vector<int> loop;
    for (int vertex : surface.faces[i].vertices) {
      const auto [number, first_use] =
          numbers[entry->second].emplace(vertex, static_cast<int>(solid.vertices.size()));
      if (first_use) solid.vertices.push_back(surface.vertices[static_cast<std::size_t>(vertex)]);
      loop.push_back(number->second);
    }
    solid.faces.push_back(std::move(loop));
  }
  return solids;
}

}  // namespace halfspace::cli
