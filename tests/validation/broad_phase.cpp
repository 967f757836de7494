// The neighbour list never loses a pair: a plate of 20 m that swings among grains of 1 cm that fly fast.

#include <map>
#include <random>
#include <set>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

using Pairs = std::set<std::pair<int, int>>;

/// Every pair of the world's blocks put to the stateless pair function.
struct BruteForce {
  Pairs touching;
  Pairs in_doubt;  // nearer to touching than rounding
};

class AllPairs {
 public:
  explicit AllPairs(std::vector<const hs_shape*> shapes) : shapes_(std::move(shapes)) {
    const int n = int(shapes_.size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) pairs_.insert(pairs_.end(), {a, b});
    }
    contacts_.resize(pairs_.size() / 2);
  }

  BruteForce detect(const Scene& scene) {
    std::vector<hs_pose> poses(shapes_.size());
    const std::int64_t count = std::int64_t(poses.size());
    scene.check(hs_world_get_poses(scene.world(), poses.data(), count, nullptr));
    scene.check(hs_pairs_detect(scene.context(), shapes_.data(), poses.data(), count, pairs_.data(),
                                std::int64_t(contacts_.size()), nullptr, nullptr, contacts_.data(), nullptr));
    BruteForce found;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const std::pair<int, int> pair{pairs_[2 * k], pairs_[2 * k + 1]};
      // Coordinates of 10 m, turned by another way: 1e-15 m, some operations long.
      if (std::abs(contacts_[k].gap) < 1e-13) {
        found.in_doubt.insert(pair);
      } else if (contacts_[k].type != HS_CONTACT_NONE) {
        found.touching.insert(pair);
      }
    }
    return found;
  }

 private:
  std::vector<const hs_shape*> shapes_;
  std::vector<int32_t> pairs_;
  std::vector<hs_contact> contacts_;
};

TEST_CASE("no pair is lost between a plate of 20 m and fast grains of 1 cm") {
  constexpr int grains = 150, steps = 400;
  constexpr double time_step = 1e-5;
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (double(random() >> 11) * 0x1p-53);
  };
  Scene scene(world_def(time_step, 0), spring_law(1e5, 0.5));
  std::vector<Shape> shapes;
  const auto make = [&](const Points& p) { shapes.push_back(make_shape(scene.context(), p)); };

  const Points plate = box(-10, -0.05, 10, 0.05);
  make(plate);
  scene.add(plate, {HS_BLOCK_PRESCRIBED, {1, 2}, 1});
  const Points swing = box(-10, -0.2, 10, -0.1);
  make(swing);
  scene.add(swing, {HS_BLOCK_RIGID, {0, 1}, -2});
  for (int i = 0; i < grains; ++i) {
    // Along the plate's two sides, half of them gathered near its middle, where they meet one another.
    const double reach = i % 2 ? 0.1 : 9.9;
    const double x = uniform(-reach, reach), y = uniform(0.06, 0.16);
    const double r = uniform(0.002, 0.01);
    Points grain;
    const int corners = 3 + int(random() % 4);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * pi * (k + uniform(-0.3, 0.3)) / corners;
      grain.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
    }
    make(grain);
    // Up to a radius of the smallest in ten steps: 0.2 mm a step.
    scene.add(grain, {HS_BLOCK_RIGID, {uniform(-20, 20), uniform(-20, 20)}, uniform(-500, 500)});
  }
  std::vector<const hs_shape*> borrowed;
  for (const Shape& shape : shapes) borrowed.push_back(shape.get());
  AllPairs all(borrowed);
  std::map<hs_block, int> index;
  for (hs_block block : scene.blocks()) index.emplace(block, int(index.size()));

  std::int64_t touching = 0, lost = 0, invented = 0, doubtful = 0;
  for (int i = 0; i < steps; ++i) {
    scene.step();
    Pairs of_world;
    for (const hs_contact& c : scene.contacts()) {
      const int a = index.at(c.block_a), b = index.at(c.block_b);
      of_world.insert({std::min(a, b), std::max(a, b)});
    }
    const BruteForce brute = all.detect(scene);
    touching += std::int64_t(brute.touching.size());
    doubtful += std::int64_t(brute.in_doubt.size());
    for (const auto& pair : brute.touching) lost += !of_world.count(pair);
    for (const auto& pair : of_world) invented += !brute.touching.count(pair) && !brute.in_doubt.count(pair);
  }
  const hs_world_report report = scene.report();
  std::printf(
      "broad phase: %lld touching pairs in %d steps, %lld lost, %lld invented, %lld within rounding of "
      "touching; %lld list builds, %lld candidates of %lld pairs\n",
      (long long)touching, steps, (long long)lost, (long long)invented, (long long)doubtful,
      (long long)report.list_builds, (long long)report.candidate_count,
      (long long)(report.block_count * (report.block_count - 1) / 2));
  CHECK(touching > 1000);
  CHECK(lost == 0);
  CHECK(invented == 0);
  CHECK(doubtful <= touching / 1000);
}

}  // namespace
