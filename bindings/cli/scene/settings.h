#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "scene/faults.h"

namespace halfspace::cli {

/// Replaces values of a scene by settings `key=value` of the command line, in their order. Keys are paths as
/// in faults: `default_law.friction_angle`, `block[2].velocity`; a name stands for the element of a list that
/// has it: `material.rock.density`. Values are TOML; a bare word is a string; without a value the key is
/// removed. Keys that the scene does not have are added, so that its reader reports those that it does not
/// know.
void apply_settings(const std::vector<std::string>& settings, toml::table& scene, Faults& faults);

/// The place of a key or value: in the file, or in a setting.
Place place_of(const toml::source_region& source);

}  // namespace halfspace::cli
