#include "notes/unusual_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "common/text.h"
#include "halfspace/check.h"
#include "scene/settings.h"

namespace halfspace::cli {
namespace {

/// A key whose usual range is that of a setting of worlds.
struct OfWorlds {
  std::string_view table;  ///< path without indices; empty: of any
  std::string_view key;
  std::int32_t setting;
  std::string_view degrees = {};  ///< range of an angle, which scenes have in degrees, for the note
};

// The first matching line applies.
constexpr OfWorlds of_worlds[] = {
    {"world", "gravity", HS_SETTING_GRAVITY},
    {"stage", "gravity", HS_SETTING_GRAVITY},
    {"", "density", HS_SETTING_DENSITY},
    {"", "young_modulus", HS_SETTING_YOUNG_MODULUS},
    {"", "poisson_ratio", HS_SETTING_POISSON_RATIO},
    {"", "damping_time", HS_SETTING_DAMPING_TIME},
    {"", "normal_damping", HS_SETTING_NORMAL_DAMPING},
    {"", "shear_damping", HS_SETTING_SHEAR_DAMPING},
    {"", "mass_damping", HS_SETTING_MASS_DAMPING},
    {"", "friction_angle", HS_SETTING_FRICTION_ANGLE, "0, or 2 to 75 degrees"},
    {"", "residual_friction_angle", HS_SETTING_FRICTION_ANGLE, "0, or 2 to 75 degrees"},
    {"", "cohesion", HS_SETTING_COHESION},
    {"", "residual_cohesion", HS_SETTING_COHESION},
    {"", "tensile_strength", HS_SETTING_TENSILE_STRENGTH},
    {"", "tensile_fracture_energy", HS_SETTING_TENSILE_FRACTURE_ENERGY},
    {"", "shear_fracture_energy", HS_SETTING_SHEAR_FRACTURE_ENERGY},
    {"bond", "normal_stiffness", HS_SETTING_BOND_NORMAL_STIFFNESS},
    {"bond", "shear_stiffness", HS_SETTING_BOND_SHEAR_STIFFNESS},
    {"", "normal_stiffness", HS_SETTING_NORMAL_STIFFNESS},
    {"", "shear_stiffness", HS_SETTING_SHEAR_STIFFNESS},
    {"world", "parallel_angle", HS_SETTING_PARALLEL_ANGLE, "0, or 0.05 to 28 degrees"},
    {"", "velocity", HS_SETTING_VELOCITY},
};

/// The usual range of the absolute value of a number, or of the length of a vector. 0 is always usual.
struct UsualRange {
  double low, high;
  std::string_view text;  ///< range and unit, for the note
  double unit = 1;        ///< that of the file in that of the range
};

/// A key that worlds do not have.
struct OfScenes {
  std::string_view table, key;
  UsualRange range;
};

constexpr OfScenes of_scenes[] = {
    {"", "traction", {100, 1e10, "0, or 100 to 1e10 Pa"}},
    {"", "pressure", {100, 1e10, "0, or 100 to 1e10 Pa"}},
    {"", "normal_stress", {100, 1e10, "0, or 100 to 1e10 Pa"}},
    {"", "shear_stress", {100, 1e10, "0, or 100 to 1e10 Pa"}},
    {"", "dip", {1.6, 90, "0, or 2 to 90 degrees"}},
    {"world", "rest_speed", {0, 0.1, "up to 0.1 m/s"}},
    {"stage", "rest_speed", {0, 0.1, "up to 0.1 m/s"}},
    {"stage", "ratio", {1e-12, 1e-2, "1e-7 to 1e-2"}},
    {"stage", "strength_factor", {0.05, 20, "0.1 to 10"}},
};

/// Keys in degrees: a multiple of pi / 12 is probably in radians.
constexpr std::string_view angles[] = {"rotation", "dip", "dip_direction", "angular_velocity"};

/// The first line of a list for a key in a table, or its end.
template <class Line, std::size_t Count>
const Line* line_of(const Line (&lines)[Count], std::string_view table, std::string_view key) {
  return std::find_if(std::begin(lines), std::end(lines), [&](const Line& line) {
    return line.key == key && (line.table.empty() || line.table == table);
  });
}

std::optional<UsualRange> usual_of(std::string_view table, std::string_view key) {
  if (const auto* line = line_of(of_scenes, table, key); line != std::end(of_scenes)) return line->range;
  const auto* line = line_of(of_worlds, table, key);
  if (line == std::end(of_worlds)) return std::nullopt;
  UsualRange range{};
  if (hs_setting_get_usual(line->setting, &range.low, &range.high) != HS_OK) return std::nullopt;
  const bool is_angle = !line->degrees.empty();
  range.text = is_angle ? line->degrees : hs_setting_usual_text(line->setting);
  range.unit = is_angle ? std::numbers::pi / 180 : 1;
  return range;
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
    const std::optional<UsualRange> usual = usual_of(table, key);
    const double measured = usual ? *size * usual->unit : 0;
    if (usual && !(measured >= usual->low && measured <= usual->high)) {
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
