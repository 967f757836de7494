#pragma once

#include <optional>
#include <string_view>

#include "scene/faults.h"

namespace halfspace::cli {

/// The longest key of a scene has three names. Recursive functions process nested tables, so that very deep
/// ones would overflow the stack.
inline constexpr int max_names = 8;

/// The first place where a TOML text joins more than `max_names` names by dots, in a key or a table header.
std::optional<Place> deep_key(std::string_view toml, int max_names);

}  // namespace halfspace::cli
