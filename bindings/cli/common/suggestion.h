#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfspace::cli {

/// The nearest of the names by edit distance; empty when none is near.
std::string_view nearest(std::string_view name, const std::vector<std::string_view>& names);

/// " (did you mean 'x'?)" for the nearest of the names, or nothing when none is near.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& names);

}  // namespace halfspace::cli
