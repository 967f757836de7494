#include "scene/read_actions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "blocks/mesh/number_table.h"
#include "common/files.h"
#include "common/text.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

using Rows = std::vector<std::vector<double>>;

/// Rows in the scene, or in a file whose path is set.
Rows read_rows(Keys& keys, const std::string& folder, std::string& file, const std::string& allowed) {
  if (!keys.either("file", "table")) return keys.rows("table", allowed);
  const std::filesystem::path path(keys.nonempty_text("file"));
  if (path.empty()) return {};  // a fault already
  file = (folder / path).string();
  if (!std::filesystem::is_regular_file(file)) {
    keys.fault("file", "no such file: " + file + "; allowed: a CSV file, named from the folder of the scene");
    return {};
  }
  try {
    Rows rows = read_number_table(path.filename().string(), content_of(file), "numbers").rows;
    if (rows.empty()) keys.fault("file", "no rows; allowed: " + allowed);
    return rows;
  } catch (const std::runtime_error& error) {
    keys.fault("file", std::string(error.what()) + "; allowed: " + allowed);
    return {};
  }
}

const char* key_of_rows(const Keys& keys) { return keys.has("file") ? "file" : "table"; }

/// Reports times that do not ascend.
bool check_times(Keys& keys, const Rows& rows) {
  const char* key = key_of_rows(keys);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double time = rows[i][0];
    const bool is_third = i > 1 && time == rows[i - 2][0];
    if (time >= rows[i - 1][0] && !is_third) continue;
    keys.fault(key, "row " + std::to_string(i) + " is at " + shortest(time) +
                        " s; allowed: times that ascend, and no more than two of them equal");
    return false;
  }
  return true;
}

/// A table whose rows have a time and `count` values, or one value for all components.
TimeTable table_of(const Keys& keys, const Rows& rows, std::size_t count) {
  const char* key = key_of_rows(keys);
  TimeTable table{.times = {}, .values = {}, .key = keys.path(key), .place = keys.place(key)};
  for (const std::vector<double>& row : rows) {
    Point value{row[1], row[1], row[1]};
    for (std::size_t k = 0; count > 1 && k < 3; ++k) value[k] = k < count ? row[k + 1] : 0;
    table.times.push_back(row[0]);
    table.values.push_back(value);
  }
  return table;
}

/// Motions and torques about the normal of the plane have one component.
bool is_about_axis(int kind) {
  return kind == HS_ACTION_ANGULAR_VELOCITY || kind == HS_ACTION_ANGULAR_ACCELERATION ||
         kind == HS_ACTION_TORQUE;
}

void read_direction(Keys& keys, Action& action) {
  const double factor = keys.number("factor", any_number(), 1);
  const bool in_plane = keys.dimension() == 2;
  if (in_plane && is_about_axis(action.kind)) {
    action.scale = {0, 0, factor};
    return;
  }
  const Point direction = keys.point("direction", required);
  if (keys.has("direction") && direction == Point{})
    keys.fault("direction", "no direction: all components are 0; allowed: one that is not 0");
  for (std::size_t k = 0; k < 3; ++k) action.scale[k] = factor * direction[k];
}

/// Reads rows [time, value] or rows of a time and all components.
/// @return the number of values of a row; empty after a fault
std::optional<std::size_t> read_values(Keys& keys, const std::string& folder, Action& action) {
  const auto dimension = static_cast<std::size_t>(keys.dimension());
  const std::string allowed =
      dimension == 2 ? "rows [time, value] or [time, x, y]" : "rows [time, value] or [time, x, y, z]";
  const Rows rows = read_rows(keys, folder, action.file, allowed);
  if (rows.empty()) return std::nullopt;
  const std::size_t count = rows.front().size() - 1;
  const bool has_components =
      count == dimension && action.kind != HS_ACTION_SERVO && !(dimension == 2 && is_about_axis(action.kind));
  if (count != 1 && !has_components) {
    keys.fault(key_of_rows(keys), "rows of " + std::to_string(count + 1) + " numbers; allowed: " +
                                      (count == dimension ? "rows [time, value] for this kind" : allowed));
    return std::nullopt;
  }
  if (!check_times(keys, rows)) return std::nullopt;
  action.table = table_of(keys, rows, count);
  return count;
}

/// Loads of 0, and accelerations of more than ten times gravity.
void note_values(Keys& keys, const Action& action) {
  constexpr double max_acceleration = 100;
  double largest = 0;
  for (const Point& value : action.table.values)
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest = std::max(largest, std::abs(action.scale[axis] * value[axis]));
  if (largest == 0 && (is_load(action.kind) || action.kind == HS_ACTION_ACCELERATION)) {
    keys.note(key_of_rows(keys), "all values are 0: they have no effect");
  } else if (largest > max_acceleration && action.kind == HS_ACTION_ACCELERATION) {
    keys.note(key_of_rows(keys), rounded(largest, 3) + " m/s2 is unusual; usual: up to 100 m/s2");
  }
}

/// Values with components of their own, or one value along a direction.
void read_table(Keys& keys, const std::string& folder, Action& action) {
  const std::optional<std::size_t> count = read_values(keys, folder, action);
  if (!count) {
    keys.has_any({"direction", "factor"});
  } else if (*count == 1) {
    read_direction(keys, action);
  } else {
    const double factor = keys.number("factor", any_number(), 1);
    action.scale = {factor, factor, factor};
  }
  if (count) note_values(keys, action);
}

Action read_action(Keys& keys, const Scene& scene) {
  Action action;
  action.on = keys.has("on") ? keys.nonempty_text("on") : keys.text("on", std::string());
  action.key = keys.path("on");
  action.place = keys.place("on");
  action.kind = keys.kind("kind", {std::begin(action_names), std::end(action_names)}, required);
  if (!keys.has("on") && !keys.is_misspelt("on") && keys.is_kind_known() &&
      action.kind != HS_ACTION_ACCELERATION)
    keys.fault("on", "missing; required: the name of a block, except for an acceleration of all blocks");
  read_table(keys, scene.folder, action);
  if (action.kind == HS_ACTION_FORCE && keys.has_any({"at"})) {
    action.at = keys.point("at", required);
    action.is_carried = keys.boolean("carried", action.is_carried);
  }
  if (action.kind == HS_ACTION_SERVO) action.max_speed = keys.number("max_speed", above(0), required);
  return action;
}

}  // namespace

TimeTable read_factors(Keys& keys) {
  if (!keys.has_any({"table"})) return {};
  const Rows rows = keys.rows("table", "rows [time, factor]");
  if (rows.empty() || !check_times(keys, rows)) return {};
  if (rows.front().size() == 2) return table_of(keys, rows, 1);
  keys.fault("table",
             "rows of " + std::to_string(rows.front().size()) + " numbers; allowed: rows [time, factor]");
  return {};
}

std::size_t read_stage_name(Keys& keys, const Scene& scene) {
  if (!keys.has_any({"stage"})) return 0;
  const std::string name = keys.text("stage", required);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    if (scene.stages[i].name == name) return i;
  }
  keys.fault("stage", "no stage is called \"" + name + "\"; allowed: the name of a [[stage]]");
  return 0;
}

int read_axes(Keys& keys, std::string_view key, const std::string& fallback, bool with_rotation) {
  const bool in_space = keys.dimension() == 3;
  const std::string axes = keys.text(key, fallback);
  int sum = 0;
  bool is_known = !axes.empty() || axes == fallback;
  for (const char axis : axes) {
    const int value = axis == 'x'                    ? HS_AXIS_X
                      : axis == 'y'                  ? HS_AXIS_Y
                      : axis == 'z' && in_space      ? HS_AXIS_Z
                      : axis == 'r' && with_rotation ? HS_AXIS_ROTATION
                                                     : 0;
    is_known = is_known && value != 0 && (sum & value) == 0;
    sum |= value;
  }
  if (!is_known) {
    keys.fault(key, '"' + axes + "\"; allowed: some of the letters " + (in_space ? "x, y and z" : "x and y") +
                        (with_rotation ? ", and r for the rotation" : "") +
                        (in_space ? ", as \"xz\"" : ", as \"xy\""));
  }
  return sum;
}

void read_actions(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Action action = read_action(keys, scene);
    action.stage = read_stage_name(keys, scene);
    keys.finish();
    scene.actions.push_back(std::move(action));
  }
}

}  // namespace halfspace::cli
