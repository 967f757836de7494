#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "notes/kinds.h"
#include "text.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

/// What one table of the file has made.
struct Made {
  std::string name, key;
  Place place;
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  bool is_free = false;
  bool is_from_file = false;
  double extent() const { return length(minus(high, low)); }
};

std::vector<Made> made_by_tables(const Start& start) {
  std::vector<Made> all;
  std::map<std::string, std::size_t> index_of;  // by key
  for_each_making(start.scene, [&](const Making& making) {
    index_of.emplace(making.key, all.size());
    all.push_back({.name = making.name, .key = making.key, .place = making.place});
  });
  for (const Block& block : start.scene.blocks)
    all[index_of.at(block.making.key)].is_from_file = !block.file.empty();
  for (const Mesh& mesh : start.scene.meshes)
    all[index_of.at(mesh.making.key)].is_from_file = !mesh.file.empty();
  for (std::size_t i = 0; i < start.layout.blocks.size(); ++i) {
    Made& made = all[index_of.at(start.layout.blocks[i].key)];
    made.is_free = made.is_free || moves_freely(start.layout.blocks[i].kind);
    for (const Point& p : start.frame.blocks[i].vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        made.low[axis] = std::min(made.low[axis], p[axis]);
        made.high[axis] = std::max(made.high[axis], p[axis]);
      }
    }
  }
  std::erase_if(all, [](const Made& made) { return !(made.extent() > 0 && std::isfinite(made.extent())); });
  return all;
}

/// A file in millimetres is a thousand times as large as what it lies beside, or as small. Floors may be
/// large, and single blocks small.
void note_extents(const Start& start, Faults& faults) {
  constexpr double most_larger = 100, most_smaller = 300, most_at_all = 1e5;
  const std::vector<Made> all = made_by_tables(start);
  for (const Made& made : all) {
    double largest = 0, smallest = INFINITY;  // of all others
    for (const Made& other : all) {
      if (other.key == made.key) continue;
      largest = std::max(largest, other.extent());
      smallest = std::min(smallest, other.extent());
    }
    if (largest == 0) continue;
    const double larger = made.extent() / largest, smaller = smallest / made.extent();
    const bool is_large = larger > (made.is_free || made.is_from_file ? most_larger : most_at_all);
    const bool is_small = smaller > (made.is_from_file ? most_smaller : most_at_all);
    if (!is_large && !is_small) continue;
    faults.note(made.place, made.key,
                quoted(made.name) + " is " + rounded(made.extent(), 3) + " m large, " +
                    rounded(is_large ? larger : smaller, 3) + " times as " + (is_large ? "large" : "small") +
                    " as all else; usual: one unit, m" +
                    (made.is_from_file ? ", by scale = 0.001 of a file in mm" : ""));
  }
}

/// Blocks whose sizes differ by more than springs and steps can serve.
void note_thicknesses(const Start& start, Faults& faults) {
  constexpr double most_ratio = 1e5;
  const auto thinner = [](const Body& a, const Body& b) { return a.thickness < b.thickness; };
  const auto [least, most] = std::minmax_element(start.bodies.begin(), start.bodies.end(), thinner);
  if (least == start.bodies.end() || !(most->thickness > most_ratio * least->thickness)) return;
  const LayoutBlock& thin = start.layout.blocks[static_cast<std::size_t>(least - start.bodies.begin())];
  const LayoutBlock& thick = start.layout.blocks[static_cast<std::size_t>(most - start.bodies.begin())];
  faults.note(thin.place, thin.key,
              quoted(thin.name) + " is " + rounded(least->thickness, 3) + " m thick, and " +
                  quoted(thick.name) + ' ' + rounded(most->thickness, 3) +
                  " m; usual: up to 1e5 times as much");
}

/// The thinnest block that moves freely, or none.
const Body* thinnest(const Start& start) {
  const Body* found = nullptr;
  for (const Body& body : start.bodies)
    if (moves_freely(body.state.kind) && (!found || body.thickness < found->thickness)) found = &body;
  return found;
}

void note_sleep(const Start& start, Faults& faults) {
  constexpr double most_fraction = 0.01;
  const double tolerance = start.scene.world.sleep_tolerance;
  const Body* thin = thinnest(start);
  if (!thin || !(tolerance > most_fraction * thin->thickness)) return;
  faults.note(start.scene.places.sleep_tolerance, "world.sleep_tolerance",
              shortest(tolerance) + " m is " + share_of_it(tolerance / thin->thickness) +
                  " the thinnest block's thickness; usual: below 1 %");
}

void note_potential_length(const Start& start, Faults& faults) {
  constexpr double most_ratio = 100;
  const double given = start.scene.world.potential_length;
  double mean = 0;
  for (const Body& body : start.bodies) mean += body.thickness / static_cast<double>(start.bodies.size());
  if (!(given > 0) || (given < most_ratio * mean && given * most_ratio > mean)) return;
  faults.note(start.scene.places.potential_length, "world.potential_length",
              shortest(given) + " m is " + share_of_it(given / mean) +
                  " the blocks' mean thickness; usual: about as long as their edges");
}

/// Coordinates of a map leave few digits for what happens between blocks.
void note_places(const Start& start, Faults& faults) {
  constexpr double most_ratio = 1e8;
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    const double far = length(point_of(start.bodies[i].state.pose.position));
    if (!(far > most_ratio * start.bodies[i].thickness)) continue;
    const LayoutBlock& block = start.layout.blocks[i];
    faults.note(block.place, block.key,
                quoted(block.name) + " is " + rounded(far, 3) + " m from the origin, " +
                    rounded(far / start.bodies[i].thickness, 3) +
                    " times its thickness; usual: an origin near the blocks");
    return;
  }
}

}  // namespace

void note_sizes(const Start& start, Faults& faults) {
  note_extents(start, faults);
  note_thicknesses(start, faults);
  note_sleep(start, faults);
  note_potential_length(start, faults);
  note_places(start, faults);
}

}  // namespace halfspace::cli
