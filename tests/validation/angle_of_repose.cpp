// The angle of repose (Wang et al. 2021, section 4.4), with fewer grains and softer springs: the full size is
// a scene in docs/examples.

#include <algorithm>
#include <map>
#include <random>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double half_width = 0.125;
constexpr double height = 0.3;
constexpr double lift_speed = 0.3;
constexpr double friction = 25 * degree;

/// A grid of triangles with shifted nodes; the border stays straight.
std::vector<Points> triangles(int columns, int rows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (double(random() >> 11) * 0x1p-53);
  };
  const auto coordinate = [&](int i, int n, double low, double high) {
    const double shift = i == 0 || i == n ? 0 : uniform(-0.2, 0.2);
    return low + (high - low) * (i + shift) / n;
  };
  std::vector<Points> nodes(std::size_t(rows) + 1);
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      const double x = coordinate(c, columns, -half_width, half_width);
      nodes[std::size_t(r)].push_back({x, coordinate(r, rows, 0, height)});
    }
  }
  std::vector<Points> grains;
  for (std::size_t r = 0; r < std::size_t(rows); ++r) {
    for (std::size_t c = 0; c < std::size_t(columns); ++c) {
      const Point corner[] = {nodes[r][c], nodes[r][c + 1], nodes[r + 1][c + 1], nodes[r + 1][c]};
      const std::size_t first = random() % 2;
      const auto at = [&](std::size_t i) { return corner[(first + i) % 4]; };
      grains.push_back({at(0), at(1), at(2)});
      grains.push_back({at(0), at(2), at(3)});
    }
  }
  return grains;
}

/// Least-squares slope, in degrees, of the surface of one side: highest grain centroid in each strip, between
/// 15 % and 85 % of the summit.
double slope_angle(const std::vector<Point>& grains, double side) {
  constexpr double strip = 0.02;
  std::map<int, Point> highest;
  double summit = 0;
  for (const Point& p : grains) {
    summit = std::max(summit, p.y);
    if (p.x * side < 0) continue;
    Point& top = highest[int(p.x * side / strip)];
    if (p.y > top.y) top = {p.x * side, p.y};
  }
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [index, p] : highest) {
    if (p.y < 0.15 * summit || p.y > 0.85 * summit) continue;
    n += 1;
    sx += p.x;
    sy += p.y;
    sxx += p.x * p.x;
    sxy += p.x * p.y;
  }
  return std::atan(-(n * sxy - sx * sy) / (n * sxx - sx * sx)) / degree;
}

/// The slopes of both flanks of a heap at rest, in degrees.
struct Slopes {
  double left, right;
};

/// What must hold at rest: nothing moves, and the plate carries the weight, but for what still rings. Kinetic
/// energy e in all on springs under a weight W makes the force on the plate swing by sqrt(2 m e) omega, omega
/// at most that of one grain. The angle: the steepest slope of loose grains is that of friction and
/// interlocking together, and nothing says that it must be the friction angle; a heap that falls down with
/// the baffles gone may also end flatter. Mean slopes of half and of twice tan(phi) are the bounds within
/// which the paper's statement, the slope is the friction angle, has any meaning.
Slopes slopes_of_heap(std::uint64_t seed) {
  constexpr double stiffness = 1e7, time_step = 2e-5, density = 2500;
  hs_world_def def = world_def(time_step);
  hs_law_def law = spring_law(stiffness, friction);
  law.normal_damping = 0.1;  // else single grains bounce on, off the plate
  Scene scene(def, law, density);
  const int32_t baffle = scene.add_material(density);
  law.friction_angle = 0;
  scene.check(hs_world_set_law(scene.world(), 0, baffle, &law));
  scene.add(box(-2, -0.05, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_block left = scene.add(box(-half_width - 0.05, 0, -half_width, height),
                                  {HS_BLOCK_PRESCRIBED, {0, lift_speed}, 0}, baffle);
  const hs_block right = scene.add(box(half_width, 0, half_width + 0.05, height),
                                   {HS_BLOCK_PRESCRIBED, {0, lift_speed}, 0}, baffle);
  std::vector<hs_block> grains;
  for (const Points& p : triangles(12, 15, seed)) grains.push_back(scene.add(p));

  const double lift_time = height / lift_speed;
  scene.step(std::llround(lift_time / time_step));
  scene.set_velocity(left, {});
  scene.set_velocity(right, {});
  // Springs without dashpots ring on for long. At rest: in half a second no grain has moved by a twentieth of
  // its size.
  constexpr double grain_size = 0.02, pause = 0.5;
  double moved = HUGE_VAL;
  hs_world_report report = scene.report();
  for (std::vector<Point> before; report.time < 5 && moved > grain_size / 20; report = scene.report()) {
    before.clear();
    for (hs_block grain : grains) before.push_back(scene.position(grain));
    scene.step(std::llround(pause / time_step));
    moved = 0;
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const Point p = scene.position(grains[i]);
      moved = std::max(moved, std::hypot(p.x - before[i].x, p.y - before[i].y));
    }
  }
  std::vector<Point> places;
  double weight = 0, mean_x = 0, widest = 0, summit = 0;
  for (hs_block grain : grains) {
    const hs_block_state s = scene.state(grain);
    places.push_back({s.pose.position[0], s.pose.position[1]});
    weight += s.mass * 9.81;
    mean_x += s.pose.position[0] / double(grains.size());
    widest = std::max(widest, std::abs(s.pose.position[0]));
    summit = std::max(summit, s.pose.position[1]);
  }
  double on_plate = 0;
  for (const hs_contact& c : scene.contacts()) {
    if (c.block_a == scene.blocks()[0]) on_plate += c.force[1];
  }
  const double angle_left = slope_angle(places, -1), angle_right = slope_angle(places, 1);
  const hs_energy e = report.energy;
  std::printf(
      "A4.4 %zu triangles: at %.2f s, moved in the last half second by %.1e m at most; slopes %.1f deg left, "
      "%.1f deg right; summit %.3f m, reach %.3f m, mean x %.4f m; plate carries %.6f of the weight; overlap "
      "%.1e m\n",
      grains.size(), report.time, moved, angle_left, angle_right, summit, widest, mean_x, on_plate / weight,
      report.largest_overlap);
  std::printf("A4.4 ledger: friction loss %.4f J, kinetic %.1e J, strain %.1e J, residual %.1e J\n",
              e.friction_loss, e.kinetic, e.strain, e.residual);
  CHECK(moved <= grain_size / 20);
  const double mass = weight / 9.81, omega = std::sqrt(stiffness / (mass / double(grains.size())));
  CHECK(std::abs(on_plate - weight) <= std::sqrt(2 * mass * e.kinetic) * omega);
  for (double angle : {angle_left, angle_right}) {
    CHECK(std::tan(angle * degree) >= 0.5 * std::tan(friction));
    CHECK(std::tan(angle * degree) <= 2 * std::tan(friction));
  }
  return {angle_left, angle_right};
}

}  // namespace

/// Mirror balance: the two slopes are those of two halves of random heaps. The logarithm of their ratio
/// scatters about 0: its mean is within three of its standard errors.
TEST_CASE("A4.4 heaps of triangles come to rest with two slopes", "[slow]") {
  constexpr int heaps = 6;
  double sum = 0, squares = 0;
  for (int seed = 1; seed <= heaps; ++seed) {
    const Slopes slopes = slopes_of_heap(std::uint64_t(seed));
    const double ratio = std::log(std::tan(slopes.left * degree) / std::tan(slopes.right * degree));
    sum += ratio;
    squares += ratio * ratio;
  }
  const double mean = sum / heaps, variance = (squares - heaps * mean * mean) / (heaps - 1);
  std::printf("A4.4 logarithm of the ratio of slopes: mean %.2f, scatter %.2f\n", mean, std::sqrt(variance));
  CHECK(std::abs(mean) <= 3 * std::sqrt(variance / heaps));
}
