#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "common/text.h"
#include "common/vector.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// The blocks of one table of the file.
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

/// Notes extents that differ by orders of magnitude. Floors may be large, and single blocks small. A file
/// that is more than 32 times larger than all else, the root of 1000, is more likely in mm than in m.
void note_extents(const Start& start, Faults& faults) {
  constexpr double max_times_larger = 100, max_times_smaller = 300, max_times_at_all = 1e5;
  constexpr double max_times_of_file = 32;
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
    const bool is_large = larger > (made.is_from_file ? max_times_of_file
                                    : made.is_free    ? max_times_larger
                                                      : max_times_at_all);
    const bool is_small = smaller > (made.is_from_file ? max_times_smaller : max_times_at_all);
    if (!is_large && !is_small) continue;
    faults.note(made.place, made.key,
                quoted(made.name) + " has an extent of " + rounded(made.extent(), 3) + " m, " +
                    rounded(is_large ? larger : smaller, 3) + " times " + (is_large ? "larger" : "smaller") +
                    " than all others; usual: lengths in m" +
                    (made.is_from_file ? ", scale = 0.001 for a file in mm" : ""));
  }
}

/// Notes ratios of thicknesses that are too large for one stiffness and one time step.
void note_thicknesses(const Start& start, Faults& faults) {
  constexpr double max_ratio = 1e5;
  const auto thinner = [](const Body& a, const Body& b) { return a.thickness < b.thickness; };
  const auto [thinnest_body, thickest_body] =
      std::minmax_element(start.bodies.begin(), start.bodies.end(), thinner);
  if (thinnest_body == start.bodies.end() ||
      !(thickest_body->thickness > max_ratio * thinnest_body->thickness))
    return;
  const LayoutBlock& thin =
      start.layout.blocks[static_cast<std::size_t>(thinnest_body - start.bodies.begin())];
  const LayoutBlock& thick =
      start.layout.blocks[static_cast<std::size_t>(thickest_body - start.bodies.begin())];
  faults.note(thin.place, thin.key,
              quoted(thin.name) + " is " + rounded(thinnest_body->thickness, 3) + " m thick, and " +
                  quoted(thick.name) + ' ' + rounded(thickest_body->thickness, 3) +
                  " m; usual: a ratio up to 1e5");
}

/// The thinnest block that moves freely, or null.
const Body* thinnest(const Start& start) {
  const Body* found = nullptr;
  for (const Body& body : start.bodies)
    if (moves_freely(body.state.kind) && (!found || body.thickness < found->thickness)) found = &body;
  return found;
}

void note_sleep(const Start& start, Faults& faults) {
  constexpr double max_fraction = 0.01;
  const double tolerance = start.scene.world.sleep_tolerance;
  const Body* thin = thinnest(start);
  if (!thin || !(tolerance > max_fraction * thin->thickness)) return;
  faults.note(start.scene.places.sleep_tolerance, "world.sleep_tolerance",
              shortest(tolerance) + " m is " + ratio_text(tolerance / thin->thickness) +
                  " the thinnest block's thickness; usual: below 1 %");
}

void note_potential_length(const Start& start, Faults& faults) {
  constexpr double max_ratio = 100;
  const double given = start.scene.world.potential_length;
  double mean = 0;
  for (const Body& body : start.bodies) mean += body.thickness / static_cast<double>(start.bodies.size());
  if (!(given > 0) || (given < max_ratio * mean && given * max_ratio > mean)) return;
  faults.note(start.scene.places.potential_length, "world.potential_length",
              shortest(given) + " m is " + ratio_text(given / mean) +
                  " the blocks' mean thickness; usual: about as long as their edges");
}

/// Large coordinates, as of a map, leave few digits for gaps.
void note_places(const Start& start, Faults& faults) {
  constexpr double max_ratio = 1e8;
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    const double far = length(point_of(start.bodies[i].state.pose.position));
    if (!(far > max_ratio * start.bodies[i].thickness)) continue;
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
