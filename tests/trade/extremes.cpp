// The program of one engine on the map of extremes: `list` names its cells, `run N` prints the error of one.
// Scenes are those of tests/extremes/map_scenes.py, as far as every engine can build them.
// ../extremes/engines runs them and draws the map.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "list_or_run.h"
#include "trial.h"

namespace halfspace_trade {
namespace {

/// The outcome of a scene by one number. The error has no dimension: it is in sizes of a block, or in parts
/// of a speed.
struct Row {
  std::string name;
  std::vector<double> values;
  std::function<double(int dimension, const Setting& setting, double value)> error;
};

/// x runs along, y or z up; the size of a block is the unit of length, and gravity is as many units as m.
struct Frame {
  int dimension;
  double unit = 1;
  double origin = 0;  // m, along every axis

  Vector at(double along, double up) const {
    return dimension == 2 ? Vector{along * unit, up * unit, 0} : Vector{along * unit, 0, up * unit};
  }
  double up(const Vector& v) const { return (dimension == 2 ? v[1] : v[2]) / unit; }
  Vector place(double along, double up) const {
    Vector p = at(along, up);
    for (int k = 0; k < dimension; ++k) p[std::size_t(k)] += origin;
    return p;
  }
  Body box(double width, double height, double along, double up) const {
    Body body;
    body.size = dimension == 2 ? Vector{width * unit, height * unit, unit}
                               : Vector{width * unit, width * unit, height * unit};
    body.position = place(along, up);
    return body;
  }
  /// Its upper face is level with the origin.
  Body plate(double width, double height = 1) const {
    Body body = box(width, height, 0, -height / 2);
    body.is_fixed = true;
    return body;
  }
  Quaternion turn(double angle) const {
    const double s = std::sin(angle / 2), c = std::cos(angle / 2);
    return dimension == 2 ? Quaternion{0, 0, s, c} : Quaternion{0, s, 0, c};
  }
};

Setting in_units(Setting setting, double unit) {
  setting.indentation *= unit;
  return setting;
}

struct Bounce {
  double unit = 1, origin = 0, speed = 5, plate = 4;
};

/// A block meets a plate squarely and comes back as fast as it came. It fails, too, where it ends elsewhere.
double bounce(int dimension, Setting setting, const Bounce& by) {
  const Frame f{dimension, by.unit, by.origin * by.unit};
  constexpr double away = 1, usual_speed = 5;
  Scene scene{.dimension = dimension, .restitution = 1, .damping = 0};
  scene.bodies = {f.plate(by.plate), f.box(1, 1, 0, 0.5 + away)};
  scene.bodies[1].velocity = f.at(0, -by.speed);
  scene.duration = 4 * away / by.speed;
  scene.impact_speed = by.speed * by.unit;
  double way_of_step = 0;
  if (setting.indentation == 0) {
    // A slow one is given no more steps than one of the usual speed; a fast one gets a few after the impact.
    setting.step *= std::max(1.0, usual_speed / by.speed);
    scene.duration = std::max(scene.duration, 8 * setting.step);
    way_of_step = by.speed * setting.step;
  }
  Trial trial(in_units(setting, by.unit));
  Trial::Run run = trial.start(scene);
  const double start = f.up(run.state(1).position);
  run.finish();
  const double way = f.up(run.state(1).position) - start, exact = by.speed * scene.duration - 2 * away;
  if (!(std::abs(way - exact) < std::max(0.5, 1.5 * way_of_step))) return HUGE_VAL;
  return std::abs(f.up(run.state(1).velocity) - by.speed) / by.speed;
}

struct Rest {
  double unit = 1, light = 1, tilt = 0, corner = 0;
  int count = 1;
  long steps = 0;  // 0: as many as take 2 s
};

/// An octagon at most, as Box2D takes no more corners; the lower edges of a box are cut off.
std::vector<Vector> cut_box(double corner) {
  const double c = 0.5 - corner;
  return {{-0.5, 0.5, 0}, {-0.5, -c, 0}, {-c, -0.5, 0}, {c, -0.5, 0}, {0.5, -c, 0}, {0.5, 0.5, 0}};
}

/// Blocks that are put one on the other stay there.
double rest(int dimension, const Setting& setting, const Rest& by) {
  const Frame f{dimension, by.unit};
  Scene scene{.dimension = dimension, .gravity = f.at(0, -10), .friction = 0.5, .duration = 2};
  scene.bodies = {f.plate(8)};
  for (int i = 0; i < by.count; ++i) {
    scene.bodies.push_back(f.box(1, 1, 0, i + 0.5));
    scene.bodies.back().rotation = f.turn(by.tilt);
  }
  scene.bodies[1].density *= by.light;
  if (by.corner > 0) scene.bodies[1].corners = cut_box(by.corner);
  const double heaviest = mass_of(scene.bodies.back(), dimension).mass;
  scene.load = heaviest * 10 * by.unit * (by.light == 1 ? by.count : 1);
  scene.is_settled = by.light == 1;
  scene.seeks_rest = true;
  if (by.steps > 0) scene.duration = double(by.steps) / 60;
  Trial trial(in_units(setting, by.unit));
  Trial::Run run = trial.start(scene);
  std::vector<State> start(1);  // of blocks; the plate stays
  for (std::size_t i = 1; i <= std::size_t(by.count); ++i) start.push_back(run.state(i));
  run.finish();
  double farthest = 0;
  for (std::size_t i = 1; i <= std::size_t(by.count); ++i) {
    const Vector p = start[i].position, q = run.state(i).position;
    farthest = std::max(farthest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / by.unit);
    if (!std::isfinite(q[0] + q[1] + q[2])) return HUGE_VAL;
  }
  return farthest;
}

/// A block that is set into a plate to this depth is outside of it after a second.
double release(int dimension, const Setting& setting, double overlap) {
  const Frame f{dimension};
  Scene scene{.dimension = dimension};
  scene.bodies = {f.plate(4, 4), f.box(1, 1, 0, 0.5 - overlap)};
  scene.load = density * 10;
  scene.damping = 0;
  Trial trial(setting);
  Trial::Run run = trial.start(scene);
  run.finish();
  const double depth = 0.5 - f.up(run.state(1).position);
  return std::isfinite(depth) ? std::max(0.0, depth) : HUGE_VAL;
}

/// One plate carries so many blocks.
double crowd(int dimension, const Setting& setting, int count) {
  const Frame f{dimension};
  constexpr double pitch = 1.5;
  const int across = dimension == 2 ? count : int(std::ceil(std::sqrt(count)));
  Scene scene{.dimension = dimension, .gravity = f.at(0, -10), .friction = 0.5, .duration = 0.5};
  scene.bodies = {f.plate(2 * pitch * across)};
  for (int i = 0; i < count; ++i) {
    Body body = f.box(1, 1, pitch * (i % across - 0.5 * across), 0.5);
    if (dimension == 3) body.position[1] = pitch * (i / across - 0.5 * across);
    scene.bodies.push_back(body);
  }
  scene.load = density * 10;
  scene.seeks_rest = true;
  Trial trial(setting);
  Trial::Run run = trial.start(scene);
  run.finish();
  double farthest = 0;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const double height = f.up(run.state(i).position);
    farthest = std::max(farthest, std::isfinite(height) ? std::abs(height - 0.5) : HUGE_VAL);
  }
  return farthest;
}

std::vector<double> decades(int first, int last, int step = 1) {
  std::vector<double> all;
  for (int n = first; step > 0 ? n <= last : n >= last; n += step) all.push_back(std::pow(10.0, n));
  return all;
}

std::vector<double> joined(std::vector<double> values, const std::vector<double>& more) {
  values.insert(values.end(), more.begin(), more.end());
  return values;
}

std::vector<Row> rows() {
  // A row stretches one member of a scene.
  const auto of_bounce = [](double Bounce::*member) {
    return [=](int dimension, const Setting& setting, double value) {
      Bounce by;
      by.*member = value;
      return bounce(dimension, setting, by);
    };
  };
  const auto of_rest = [](auto Rest::*member, int count = 1) {
    return [=](int dimension, const Setting& setting, double value) {
      Rest by;
      by.count = count;
      by.*member = std::remove_reference_t<decltype(by.*member)>(value);
      return rest(dimension, setting, by);
    };
  };
  return {
      {"mass of the lower of two blocks", decades(0, -8, -1), of_rest(&Rest::light, 2)},
      {"width of the plate it meets", decades(0, 9), of_bounce(&Bounce::plate)},
      {"smallest edge", decades(-1, -12, -1), of_rest(&Rest::corner)},
      {"tilt between faces that meet", decades(-5, -15, -1), of_rest(&Rest::tilt)},
      {"distance from the origin", joined({0}, decades(1, 12)), of_bounce(&Bounce::origin)},
      {"size of the block, m, bounce", decades(-12, 12, 2), of_bounce(&Bounce::unit)},
      {"size of the block, m, rest", decades(-12, 12, 2), of_rest(&Rest::unit)},
      {"speed of an impact, m/s", decades(-6, 5), of_bounce(&Bounce::speed)},
      {"blocks in a stack", {1, 2, 5, 10, 30, 100, 300, 1000}, of_rest(&Rest::count)},
      {"steps at rest, of 1/60 s", decades(2, 5), of_rest(&Rest::steps)},
      {"overlap at the start", joined(decades(-6, -1), {0.3, 0.45, 0.6, 0.9}), release},
      {"blocks on one plate", decades(1, 4),
       [](int dimension, const Setting& setting, double count) {
         return crowd(dimension, setting, int(count));
       }},
  };
}

/// The setting that a user takes first, and, where there are iterations to choose, what he takes when that
/// will not do: the most of them, and steps of an eighth.
std::vector<Setting> chosen_settings() {
  const std::vector<Setting> all = settings();
  if (all.front().indentation > 0) return {{all.front().way, 1e-4, 0.5}};
  return {all.front(), {all.back().way, 0, 1.0 / 480}};
}

struct Cell {
  Row row;
  int dimension;
  Setting setting;
  double value;
};

std::vector<Cell> cells() {
  std::vector<Cell> all;
  for (const Row& row : rows())
    for (const int dimension : {2, 3})
      for (const Setting& setting : chosen_settings())
        for (const double value : row.values) {
          const bool has_polygons = row.name == "smallest edge";
          if (knows_dimension(dimension) && (dimension == 2 || !has_polygons))
            all.push_back({row, dimension, setting, value});
        }
  return all;
}

void print_name(const Cell& c) {
  std::printf("%s|%d|%s|%s|%.6g|%.6g", c.row.name.c_str(), c.dimension, engine_name(), c.setting.way.c_str(),
              c.setting.step, c.value);
}

void run(const Cell& c) { std::printf("%.6g\n", c.row.error(c.dimension, c.setting, c.value)); }

}  // namespace
}  // namespace halfspace_trade

int main(int argc, char** argv) {
  using namespace halfspace_trade;
  return list_or_run(argc, argv, cells, print_name, run);
}
