#pragma once

#include <optional>
#include <string_view>

#include "scene/faults.h"

namespace halfspace::cli {

/// The first place where a TOML text joins more than `max_names` names by dots, in a key or a table header.
std::optional<Place> deep_key(std::string_view toml, int max_names);

}  // namespace halfspace::cli
