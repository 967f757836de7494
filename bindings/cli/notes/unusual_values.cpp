#include "notes/unusual_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "common/text.h"
#include "scene/settings.h"

namespace halfspace::cli {
namespace {

/// The usual range of the absolute value of a number, or of the length of a vector. 0 is always usual.
struct Usual {
  std::string_view table;  ///< path without indices; empty: of any
  std::string_view key;
  double low, high;
  std::string_view text;  ///< range and unit, for the note
};

// The first matching line applies.
constexpr Usual usual_values[] = {
    {"world", "gravity", 1, 25, "9.81 m/s2, 1.62 on the moon"},
    {"stage", "gravity", 1, 25, "9.81 m/s2, 1.62 on the moon"},
    {"", "density", 50, 19500, "50 to 19500 kg/m3, 2700 of rock"},
    {"", "young_modulus", 1e6, 2e12, "1e6 to 2e12 Pa, 5e10 of rock"},
    {"", "poisson_ratio", 0, 0.495, "0 to 0.49"},
    {"", "damping_time", 0, 0.02, "up to 0.02 s"},
    {"", "normal_damping", 0, 1, "0 to 1, a fraction of critical damping"},
    {"", "shear_damping", 0, 1, "0 to 1, a fraction of critical damping"},
    {"", "mass_damping", 0, 100, "up to 100 1/s"},
    {"", "friction_angle", 2, 75, "0, or 2 to 75 degrees"},
    {"", "residual_friction_angle", 2, 75, "0, or 2 to 75 degrees"},
    {"", "cohesion", 100, 1e9, "0, or 100 to 1e9 Pa"},
    {"", "residual_cohesion", 100, 1e9, "0, or 100 to 1e9 Pa"},
    {"", "tensile_strength", 100, 1e9, "0, or 100 to 1e9 Pa"},
    {"", "tensile_fracture_energy", 0.1, 1e6, "0, or 0.1 to 1e6 J/m2"},
    {"", "shear_fracture_energy", 0.1, 1e6, "0, or 0.1 to 1e6 J/m2"},
    {"bond", "normal_stiffness", 1e6, 1e17, "1e6 to 1e17 Pa/m"},
    {"bond", "shear_stiffness", 1e5, 1e17, "0, or 1e5 to 1e17 Pa/m"},
    {"", "normal_stiffness", 1e3, 1e14, "1e3 to 1e14 in N/m, Pa/m or Pa"},
    {"", "shear_stiffness", 1e2, 1e14, "0, or 1e2 to 1e14 in N/m or Pa/m"},
    {"", "traction", 100, 1e10, "0, or 100 to 1e10 Pa"},
    {"", "pressure", 100, 1e10, "0, or 100 to 1e10 Pa"},
    {"", "normal_stress", 100, 1e10, "0, or 100 to 1e10 Pa"},
    {"", "shear_stress", 100, 1e10, "0, or 100 to 1e10 Pa"},
    {"world", "parallel_angle", 0.05, 28, "0, or 0.05 to 28 degrees"},
    {"", "dip", 1.6, 90, "0, or 2 to 90 degrees"},
    {"world", "rest_speed", 0, 0.1, "up to 0.1 m/s"},
    {"stage", "rest_speed", 0, 0.1, "up to 0.1 m/s"},
    {"stage", "ratio", 1e-12, 1e-2, "1e-7 to 1e-2"},
    {"stage", "strength_factor", 0.05, 20, "0.1 to 10"},
    {"", "velocity", 0, 1000, "up to 1000 m/s"},
};

/// Keys in degrees: a multiple of pi / 12 is probably in radians.
constexpr std::string_view angles[] = {"rotation", "dip", "dip_direction", "angular_velocity"};

const Usual* usual_of(std::string_view table, std::string_view key) {
  const auto* found = std::find_if(std::begin(usual_values), std::end(usual_values), [&](const Usual& usual) {
    return usual.key == key && (usual.table.empty() || usual.table == table);
  });
  return found == std::end(usual_values) ? nullptr : found;
}

std::optional<double> number_of(const toml::node& node) {
  const std::optional<double> value = node.value<double>();
  return node.is_number() && value && std::isfinite(*value) ? value : std::nullopt;
}

/// The absolute value of a number, or the length of a vector.
std::optional<double> size_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list) {
    const std::optional<double> value = number_of(node);
    return value ? std::optional(std::abs(*value)) : std::nullopt;
  }
  double length = 0;
  for (const toml::node& item : *list) length = std::hypot(length, number_of(item).value_or(0));
  return length;
}

std::string written(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list) return shortest(number_of(node).value_or(0));
  std::string text;
  for (const toml::node& item : *list)
    text += (text.empty() ? "" : ", ") + shortest(number_of(item).value_or(0));
  return '[' + text + ']';
}

/// Within a thousandth of a multiple of 15 degrees in radians, up to a whole turn.
bool is_like_radians(double angle) {
  const double multiple = angle * 12 / std::numbers::pi;
  const double nearest = std::round(multiple);
  return nearest >= 1 && nearest <= 24 && std::abs(multiple - nearest) <= 1e-3 * nearest;
}

/// Visits all tables of a scene.
class Walk {
 public:
  explicit Walk(Faults& faults) : faults_(faults) {}

  void through(const toml::table& table, const std::string& path, const std::string& kind) {
    const auto below = [](const std::string& parent, std::string_view key) {
      return (parent.empty() ? "" : parent + '.') + std::string(key);
    };
    for (const auto& [key, node] : table) {
      const std::string place = below(path, key.str()), name = below(kind, key.str());
      if (const toml::table* inner = node.as_table()) {
        through(*inner, place, name);
      } else if (const toml::array* list = node.as_array(); list && list->is_homogeneous<toml::table>()) {
        for (std::size_t i = 0; i < list->size(); ++i)
          through(*(*list)[i].as_table(), place + '[' + std::to_string(i) + ']', name);
      } else {
        check(node, place, kind, key.str());
      }
    }
  }

 private:
  void check(const toml::node& node, const std::string& path, std::string_view table, std::string_view key) {
    const std::optional<double> size = size_of(node);
    if (!size || *size == 0) return;
    const Usual* usual = usual_of(table, key);
    if (usual && !(*size >= usual->low && *size <= usual->high)) {
      note(node, path, written(node) + " is unusual; usual: " + std::string(usual->text));
    } else if (key == "poisson_ratio" && number_of(node) < 0) {
      note(node, path, written(node) + " is unusual; usual: " + std::string(usual->text));
    } else if (std::find(std::begin(angles), std::end(angles), key) != std::end(angles) &&
               is_like_radians(*size)) {
      note(node, path,
           written(node) + " is " + rounded(*size * 180 / std::numbers::pi, 4) +
               " degrees in radians; usual: degrees");
    }
  }

  void note(const toml::node& node, const std::string& path, const std::string& text) {
    faults_.note(place_of(node.source()), path, text);
  }

  Faults& faults_;
};

}  // namespace

void note_unusual_values(const toml::table& scene, Faults& faults) { Walk(faults).through(scene, "", ""); }

}  // namespace halfspace::cli
