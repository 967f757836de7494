#pragma once

// What the settings of Box2D 3 and Box3D have in common.

#include <map>
#include <string>

#include "engine.h"

namespace halfspace_trade {

struct SubSteps {
  int count;  // in a step
  bool is_tuned;
};

inline const std::map<std::string, SubSteps> sub_step_ways = {
    {"4 sub-steps", {4, false}},
    {"8 sub-steps, tuned", {8, true}},
    {"16 sub-steps, tuned", {16, true}},
};

inline std::vector<Setting> sub_step_settings() {
  return with_frame_steps({"4 sub-steps", "8 sub-steps, tuned", "16 sub-steps, tuned"});
}

/// The engines leave overlaps alone up to 5 mm times this.
inline float length_units_per_meter(const SubSteps& way) { return way.is_tuned ? 0.1f : 1; }

/// Tuned contacts are as stiff as sub-steps permit, and separate overlaps faster than by the default 3 m/s.
template <class WorldDefinition>
void set_contacts(WorldDefinition& def, const SubSteps& way, double time_step) {
  if (!way.is_tuned) return;
  def.contactHertz = float(way.count / (4 * time_step));
  if constexpr (requires { def.contactSpeed; })
    def.contactSpeed = 100;
  else
    def.maxContactPushSpeed = 100;  // its name in Box2D 3.1
}

template <class Version>
std::string with_version(const std::string& name, const Version& version) {
  return name + " " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.revision);
}

}  // namespace halfspace_trade
