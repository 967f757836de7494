#include "scene/read_tracked.h"

#include <algorithm>
#include <string>
#include <utility>

#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

/// A name that begins columns of the history: no block, point or joint before it has the same one.
std::string read_new_name(Keys& keys, const Output& output) {
  std::string name = read_name(keys);
  const auto has_name = [&](const auto& tracked) { return tracked.name == name; };
  const bool is_taken =
      std::find(output.tracked.begin(), output.tracked.end(), name) != output.tracked.end() ||
      std::any_of(output.tracked_points.begin(), output.tracked_points.end(), has_name) ||
      std::any_of(output.tracked_joints.begin(), output.tracked_joints.end(), has_name);
  if (is_taken && !name.empty()) keys.fault("name", "used twice: \"" + name + "\"; allowed: a new name");
  return name;
}

}  // namespace

void read_tracked_points(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    TrackedPoint point{
        .name = read_new_name(keys, scene.output), .key = keys.path("at"), .place = keys.place("at")};
    point.at = keys.point("at", required);
    if (keys.has("at")) scene.output.tracked_points.push_back(std::move(point));
    keys.finish();
  }
}

void read_tracked_joints(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    const char* given = keys.either("blocks", "at") ? "blocks" : "at";
    TrackedJoint joint{.name = read_new_name(keys, scene.output),
                       .blocks = {},
                       .key = keys.path(given),
                       .place = keys.place(given)};
    bool is_given = keys.has(given);
    if (keys.has("blocks")) {
      std::vector<Place> places;
      joint.blocks = keys.texts("blocks", places, std::vector<std::string>{});
      is_given = joint.blocks.size() == 2 && joint.blocks[0] != joint.blocks[1];
      if (!is_given) keys.fault("blocks", "not a pair of blocks; allowed: two names, [\"a\", \"b\"]");
      if (keys.has("at")) keys.fault("at", "the blocks are given as well; allowed: one of the two");
    } else {
      joint.at = keys.point("at", required);
    }
    if (is_given) scene.output.tracked_joints.push_back(std::move(joint));
    keys.finish();
  }
}

}  // namespace halfspace::cli
