#include "tasks.h"

#include <algorithm>
#include <cmath>

#include "exact.h"

namespace halfspace_trade {
namespace {

constexpr double degree = M_PI / 180;

/// Parts that are the same in the plane and in space: x runs along, y or z up, and a body is 1 m deep.
struct Frame {
  int dimension;

  Vector at(double along, double up) const {
    return dimension == 2 ? Vector{along, up, 0} : Vector{along, 0, up};
  }
  double up(const Vector& v) const { return dimension == 2 ? v[1] : v[2]; }
  Body box(double width, double height, double along, double up) const {
    Body body;
    body.size = dimension == 2 ? Vector{width, height, 1} : Vector{width, 1, height};
    body.position = at(along, up);
    return body;
  }
  Body plate(double width) const {
    Body body = box(width, 2, 0, -1);
    if (dimension == 3) body.size[1] = 10;
    body.is_fixed = true;
    return body;
  }
  /// Turned from along to up.
  Quaternion turn(double angle) const {
    const double s = std::sin(angle / 2), c = std::cos(angle / 2);
    return dimension == 2 ? Quaternion{0, 0, s, c} : Quaternion{0, -s, 0, c};
  }
  double tilt(const Quaternion& q) const { return 2 * std::atan2(dimension == 2 ? q[2] : -q[1], q[3]); }
  double spin(const Vector& v) const { return dimension == 2 ? v[2] : -v[1]; }
  /// A level plane stands for a slope when gravity is turned.
  Vector gravity_on_slope(double angle) const {
    return at(gravity * std::sin(angle), -gravity * std::cos(angle));
  }
};

/// Where it turns from false to true, between the two. The first to be tried is the middle, here the exact
/// answer: no error is below half of the last interval, and one of half the first says that it nowhere
/// turned.
template <class Holds>
double bisect(double no, double yes, Holds&& holds) {
  for (int i = 0; i < 14; ++i) {
    const double middle = (no + yes) / 2;
    (holds(middle) ? yes : no) = middle;
  }
  return (no + yes) / 2;
}

std::string named(const std::string& task, bool is_settled) { return is_settled ? task + ", settled" : task; }

Scene block_on_slope(Frame f, double slope, double friction) {
  Scene scene{.dimension = f.dimension, .gravity = f.gravity_on_slope(slope), .friction = friction};
  scene.bodies = {f.plate(200), f.box(1, 1, 0, 0.5)};
  scene.load = density * gravity * std::cos(slope);
  return scene;
}

Task slide(Frame f, bool is_settled) {
  const double slope = 30 * degree, friction = std::tan(20 * degree);
  const double way = 0.5 * gravity * (std::sin(slope) - friction * std::cos(slope));
  return {named("slide", is_settled), f.dimension, way, way, [=](Trial& trial) {
            Scene scene = block_on_slope(f, slope, friction);
            scene.is_settled = is_settled;
            Trial::Run run = trial.start(scene);
            run.finish();
            return run.state(1).position[0];
          }};
}

/// A block on a slope: the least friction that holds it.
Task critical_friction(Frame f, bool is_settled) {
  const double slope = 30 * degree, exact = std::tan(slope);
  return {named("critical friction", is_settled), f.dimension, exact, exact, [=](Trial& trial) {
            return bisect(0.5 * exact, 1.5 * exact, [&](double friction) {
              Scene scene = block_on_slope(f, slope, friction);
              scene.is_settled = is_settled;
              scene.seeks_rest = true;
              scene.duration = 10;
              Trial::Run run = trial.start(scene);
              run.finish();
              return run.state(1).position[0] < 0.01;
            });
          }};
}

/// A cube in a trough of two planes at right angles, as Hoek and Bray's symmetric wedge.
Task wedge() {
  const double plunge = 20 * degree, exact = std::tan(plunge) * std::sin(45 * degree);
  return {"wedge", 3, exact, exact, [=](Trial& trial) {
            return bisect(0.5 * exact, 1.5 * exact, [&](double friction) {
              Scene scene{.dimension = 3, .friction = friction, .duration = 10, .seeks_rest = true};
              const double across = -gravity * std::cos(plunge) / std::sqrt(2.0);
              scene.gravity = {gravity * std::sin(plunge), across, across};
              Body floor, wall, block;
              floor.size = {200, 6, 2}, floor.position = {0, 1.5, -1};
              wall.size = {200, 2, 6}, wall.position = {0, -1.5, 2};
              floor.is_fixed = wall.is_fixed = true;
              block.position = {0, 0, 0.5};
              scene.bodies = {floor, wall, block};
              scene.load = -density * across;
              Trial::Run run = trial.start(scene);
              run.finish();
              return run.state(2).position[0] < 0.01;
            });
          }};
}

/// The second apex after a fall from 1 m.
Task bounce(Frame f) {
  const double fall = std::sqrt(2 / gravity);
  return {"bounce", f.dimension, 1, 1, [=](Trial& trial) {
            Scene scene{.dimension = f.dimension, .gravity = f.at(0, -gravity)};
            scene.bodies = {f.plate(10), f.box(1, 1, 0, 1.5)};
            scene.restitution = 1, scene.damping = 0;
            scene.duration = 4 * fall;
            scene.impact_speed = gravity * fall;
            Trial::Run run = trial.start(scene);
            run.finish();
            return f.up(run.state(1).position) - 0.5;
          }};
}

/// An octagon or a cube strikes with a corner below its centroid and slips: the spin that friction gives it.
Task oblique_impact(Frame f) {
  const double friction = f.dimension == 2 ? 0.2 : 0.1, down = 2, along = 4;
  Body body;
  double radius = 0.5;
  if (f.dimension == 2) {
    for (int i = 0; i < 8; ++i)
      body.corners.push_back(
          {radius * std::cos((i - 2) * 45 * degree), radius * std::sin((i - 2) * 45 * degree), 0});
  } else {
    radius = std::sqrt(3.0) / 2;
    // The diagonal from the corner at -1/2, -1/2, -1/2 stands upright.
    const double half = 0.5 * std::acos(1 / std::sqrt(3.0)), s = std::sin(half) / std::sqrt(2.0);
    body.rotation = {s, -s, 0, std::cos(half)};
  }
  const Mass mass = mass_of(body, f.dimension);
  const double exact =
      2 * friction * down * mass.mass * radius / (f.dimension == 2 ? mass.inertia[2] : mass.inertia[0]);
  body.position = f.at(0, radius + 0.02);
  body.velocity = f.at(along, -down);
  return {"oblique impact", f.dimension, exact, exact, [=](Trial& trial) {
            Scene scene{.dimension = f.dimension, .friction = friction, .restitution = 1, .damping = 0};
            scene.duration = 0.3;  // soft corners part late
            scene.bodies = {f.plate(10), body};
            scene.impact_speed = down;
            Trial::Run run = trial.start(scene);
            run.finish();
            return -f.spin(run.state(1).spin);
          }};
}

/// A brick turns about the axis on which it cannot stay: how far it is off from where it should be turned.
Task tumbling() {
  Body brick;
  brick.size = {1, 2, 3};
  brick.spin = {0.02, 4, 0.02};
  const Quaternion exact = turned_freely(brick, 10);
  return {"tumbling", 3, 0, 1, [=](Trial& trial) {
            Scene scene{.dimension = 3, .bodies = {brick}, .duration = 10};
            scene.load = density, scene.damping = 0;
            Trial::Run run = trial.start(scene);
            run.finish();
            return angle_between(run.state(0).rotation, exact);
          }};
}

/// The way of a stack's top from where it was put.
Task stack(Frame f, int count, bool is_settled) {
  return {named("stack of " + std::to_string(count), is_settled), f.dimension, 0, 1, [=](Trial& trial) {
            Scene scene{
                .dimension = f.dimension, .gravity = f.at(0, -gravity), .friction = 0.5, .duration = 5};
            scene.bodies = {f.plate(10)};
            for (int i = 0; i < count; ++i) scene.bodies.push_back(f.box(1, 1, 0, i + 0.5));
            if (count > 10) scene.duration = 1;  // s; whether it stands for long is asked of ten
            scene.load = density * gravity * count;
            scene.seeks_rest = true;
            scene.is_settled = is_settled;
            Trial::Run run = trial.start(scene);
            const State start = run.state(std::size_t(count));
            run.finish();
            const State top = run.state(std::size_t(count));
            return std::hypot(top.position[0] - start.position[0], top.position[1] - start.position[1],
                              top.position[2] - start.position[2]);
          }};
}

/// The steepest slope on which a slab of 1 by 4 stays upright, as the tangent.
Task toppling(Frame f) {
  const double exact = 0.25;
  return {"toppling column", f.dimension, exact, exact, [=](Trial& trial) {
            return bisect(0.5 * exact, 1.5 * exact, [&](double tangent) {
              Scene scene = block_on_slope(f, std::atan(tangent), 1);
              scene.bodies[1] = f.box(1, 4, 0, 2);
              scene.load *= 4;
              scene.seeks_rest = true;
              scene.duration = 10;
              Trial::Run run = trial.start(scene);
              while (!run.is_over() && std::abs(f.tilt(run.state(1).rotation)) < 0.2) run.step(10);
              return !run.is_over();
            });
          }};
}

/// A slab that rocks from edge to edge.
class Rocking {
 public:
  explicit Rocking(Frame f) : f_(f), slab_(width, height, 0.5 * std::atan(width / height)) {}

  Task time() const {
    const double exact = slab_.time_to_impact();
    return {"rocking, time to impact", f_.dimension, exact, exact, [*this](Trial& trial) {
              Trial::Run run = trial.start(scene());
              double before = 0, after = f_.tilt(run.state(1).rotation);
              while (!run.is_over() && after > 0) {
                before = after;
                run.step();
                after = f_.tilt(run.state(1).rotation);
              }
              return run.time() + after / (before - after) * run.time_step();
            }};
  }

  Task tilt_after() const {
    const double exact = slab_.tilt_after_impact();
    return {"rocking, after impact", f_.dimension, exact, exact, [*this](Trial& trial) {
              Trial::Run run = trial.start(scene());
              double least = 0;
              while (!run.is_over()) {
                run.step();
                least = std::min(least, f_.tilt(run.state(1).rotation));
              }
              return -least;
            }};
  }

 private:
  static constexpr double width = 0.5, height = 2;

  Scene scene() const {
    Scene scene{.dimension = f_.dimension, .gravity = f_.at(0, -gravity), .friction = 1};
    const double turn = slab_.tilt();
    Body slab = f_.box(width, height, 0, 0);
    // It stands on its left lower corner.
    slab.rotation = f_.turn(turn);
    slab.position = f_.at((width * std::cos(turn) - height * std::sin(turn)) / 2,
                          (width * std::sin(turn) + height * std::cos(turn)) / 2);
    scene.bodies = {f_.plate(10), slab};
    scene.load = density * gravity * width * height;
    scene.duration = 1.9 * slab_.time_to_impact();
    scene.damping = 1;
    return scene;
  }

  Frame f_;
  RockingSlab slab_;
};

/// Ten blocks with gaps of a hundredth in a row: the first one's speed arrives at the last.
Task row(Frame f) {
  const double speed = 5;
  return {"row of ten", f.dimension, speed, speed, [=](Trial& trial) {
            Scene scene{.dimension = f.dimension, .restitution = 1, .duration = 0.2};
            for (int i = 0; i < 10; ++i) scene.bodies.push_back(f.box(1, 1, 1.01 * i, 0));
            scene.bodies[0].velocity = f.at(speed, 0);
            scene.impact_speed = speed, scene.damping = 0;
            Trial::Run run = trial.start(scene);
            run.finish();
            return run.state(9).velocity[0];
          }};
}

}  // namespace

std::vector<Task> tasks() {
  std::vector<Task> all;
  for (const Frame f : {Frame{2}, Frame{3}}) {
    const Rocking rocking(f);
    for (const bool is_settled : {false, true}) {
      all.push_back(slide(f, is_settled));
      all.push_back(critical_friction(f, is_settled));
      all.push_back(stack(f, 10, is_settled));
      if (f.dimension == 2) all.push_back(stack(f, 100, is_settled));
    }
    for (Task task :
         {bounce(f), oblique_impact(f), toppling(f), rocking.time(), rocking.tilt_after(), row(f)})
      all.push_back(std::move(task));
  }
  all.push_back(wedge());
  all.push_back(tumbling());
  return all;
}

}  // namespace halfspace_trade
