#pragma once

#include <optional>
#include <string_view>

#include "faults.h"

namespace halfspace::cli {

/// Where a TOML text first joins more than so many names by dots, in a key or in the head of a table.
std::optional<Place> deep_key(std::string_view toml, int most_names);

}  // namespace halfspace::cli
