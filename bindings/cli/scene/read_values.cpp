#include "scene/read_values.h"

#include <algorithm>

#include "common/suggestion.h"

namespace halfspace::cli {

double degrees(Keys& keys, std::string_view key, Range range, std::optional<double> fallback) {
  return degree * keys.number(key, range, fallback);
}

Point rotation(Keys& keys, std::string_view key) {
  Point angles{};
  if (keys.dimension() == 2) {
    angles[2] = keys.number(key, any_number(), 0.0);
  } else {
    angles = keys.point(key, Point{});
  }
  for (double& component : angles) component *= degree;
  return angles;
}

std::optional<Tensor> read_stress(Keys& keys) {
  if (!keys.has_any({"normal_stress", "shear_stress"})) return std::nullopt;
  const Point normal = keys.point("normal_stress", required);
  Point shear{};
  if (keys.dimension() == 2) {
    shear[2] = keys.number("shear_stress", any_number(), 0.0);
  } else {
    shear = keys.point("shear_stress", shear);
  }
  return Tensor{normal[0], shear[2], shear[1], shear[2], normal[1], shear[0], shear[1], shear[0], normal[2]};
}

std::string read_name(Keys& keys) {
  const std::string name = keys.text("name", required);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
  if (keys.has_text("name") && (name.empty() || !plain)) {
    keys.fault("name", "not a name: \"" + name + "\"; allowed: letters, digits, '_', '-' and '.'");
  }
  return name;
}

std::optional<int> material_index(Keys& keys, std::string_view key, const std::string& name,
                                  const Scene& scene) {
  std::vector<std::string_view> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  const bool has_nameless = std::find(names.begin(), names.end(), "") != names.end();
  if (!scene.has_all_names || has_nameless) return std::nullopt;  // reported already
  keys.fault(key, "no such material: \"" + name + '"' + suggestion(name, names) +
                      "; allowed: the name of a [[material]]");
  return std::nullopt;
}

std::optional<std::pair<int, int>> read_between(Keys& keys, const Scene& scene) {
  std::vector<Place> places;
  const std::vector<std::string> between = keys.texts("between", places, required);
  if (between.empty()) return std::nullopt;  // a fault already
  if (between.size() != 2) {
    keys.fault("between", std::to_string(between.size()) + " materials; allowed: two, [\"a\", \"b\"]");
    return std::nullopt;
  }
  const std::optional<int> a = material_index(keys, "between", between[0], scene);
  const std::optional<int> b = material_index(keys, "between", between[1], scene);
  return a && b ? std::optional(std::pair(*a, *b)) : std::nullopt;
}

bool spans(const Point& low, const Point& high, int dimension) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    if (!(high[axis] > low[axis])) return false;
  }
  return true;
}

}  // namespace halfspace::cli
