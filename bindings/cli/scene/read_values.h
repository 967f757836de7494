#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

inline constexpr double degree = std::numbers::pi / 180;

/// An angle in radians; the file has degrees.
double degrees(Keys& keys, std::string_view key, Range range, std::optional<double> fallback);

/// A rotation or an angular velocity in radians; the file has degrees. About the normal of the plane in 2D, a
/// vector in 3D; zero by default.
Point rotation(Keys& keys, std::string_view key);

/// `normal_stress` and `shear_stress`; in 3D the shear stresses are those of yz, zx and xy. Empty if neither
/// is given.
std::optional<Tensor> read_stress(Keys& keys);

/// The key `name`. Names become columns of a CSV file, so only characters that need no quotes are allowed.
std::string read_name(Keys& keys);

/// The index of the material that a key names; empty, with a fault, if there is no such material.
std::optional<int> material_index(Keys& keys, std::string_view key, const std::string& name,
                                  const Scene& scene);

/// The key `between`: the indices of two materials; empty, with a fault, if it names no such pair.
std::optional<std::pair<int, int>> read_between(Keys& keys, const Scene& scene);

/// True if a box with these corners has a size in every direction.
bool spans(const Point& low, const Point& high, int dimension);

}  // namespace halfspace::cli
