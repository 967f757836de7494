#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "keys.h"
#include "scene.h"

namespace halfspace::cli {

inline constexpr double degree = std::numbers::pi / 180;

/// An angle, in degrees in the file and in radians here.
double degrees(Keys& keys, std::string_view key, Range range, std::optional<double> fallback);

/// A turn or a spin, in degrees: about the normal of the plane in 2D, a vector in 3D; none by default.
Point rotation(Keys& keys, std::string_view key);

/// `normal_stress` and `shear_stress`: in 3D the shear stresses are those of yz, zx and xy; none where
/// neither is given.
std::optional<Tensor> read_stress(Keys& keys);

/// The key `name`. Names become columns of a table, so they are kept to what needs no quotes.
std::string read_name(Keys& keys);

/// The index of a material that a key names; none, and a fault, if there is no such material.
std::optional<int> material_index(Keys& keys, std::string_view key, const std::string& name,
                                  const Scene& scene);

/// The key `between`: the indices of two materials; none, and a fault, if it names no such pair.
std::optional<std::pair<int, int>> read_between(Keys& keys, const Scene& scene);

/// Does a box with these corners have a size in every direction?
bool spans(const Point& low, const Point& high, int dimension);

}  // namespace halfspace::cli
