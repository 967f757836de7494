// Random bodies of finite elements that hit each other by a law without a spring: none goes into another, and
// no energy comes up.

#include <Eigen/LU>

#include "catch.h"
#include "validation/random_bodies.h"
#include "validation/reacting.h"

namespace {

using namespace halfspace_test;

struct Outcome {
  double deepest = 0;  // node in another body's cell, over the size of a cell
  double most_energy = 0;
  double momentum_error = 0;
};

using Simplex = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// How deep a point lies in a simplex: < 0 outside.
double depth_in(const Simplex& simplex, int dimension, const Node& point) {
  const Eigen::MatrixXd edges = (simplex.rightCols(dimension).colwise() - simplex.col(0)).topRows(dimension);
  const Eigen::MatrixXd gradients = edges.inverse();
  const Eigen::VectorXd weights = gradients * (point - simplex.col(0)).head(dimension);
  double depth = (1 - weights.sum()) / gradients.colwise().sum().norm();
  for (int i = 0; i < dimension; ++i) depth = std::min(depth, weights[i] / gradients.row(i).norm());
  return depth;
}

class Collision {
 public:
  Collision(int32_t kind, double friction, unsigned seed)
      : dimension_(dimension_of(kind)),
        scene_(mesh_world_def(dimension_), law_without_spring(std::atan(friction)), 2000, {1e8, 0.25}) {
    Random random(seed);
    bodies_[0] = add(kind, 2, {-1.9, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, random);
    bodies_[1] = add(kind, 3, {0, 0, 0}, random);
    const Nodes nodes = scene_.positions(bodies_[0]);
    Node center = Node::Zero(), spin(0, 0, random.uniform(-2, 2));
    for (const Node& node : nodes) center += node / double(nodes.size());
    if (dimension_ == 3) spin += Node(random.uniform(-2, 2), random.uniform(-2, 2), 0);
    Nodes velocities;
    for (const Node& node : nodes) velocities.push_back(Node(speed, 0, 0) + spin.cross(node - center));
    scene_.set_velocities(bodies_[0], velocities);
  }

  Outcome run() {
    Outcome outcome;
    const double energy = scene_.energy_present();
    const Node momentum = this->momentum();
    for (int i = 0; scene_.report().time < 2.5 / speed; ++i) {
      scene_.step();
      if (i % 5 != 0) continue;
      outcome.deepest = std::max(outcome.deepest, deepest());
      outcome.most_energy = std::max(outcome.most_energy, scene_.energy_present() / energy);
    }
    outcome.momentum_error = (this->momentum() - momentum).norm() / momentum.norm();
    return outcome;
  }

 private:
  static constexpr double speed = 8;

  hs_body add(int32_t kind, int count, const Triple& place, Random& random) {
    MeshWords words = brick(dimension_, {1, 1, 1}, {count, count, count}, [&](int) { return kind; });
    Eigen::Quaterniond turn(Eigen::AngleAxisd(random.uniform(0, 7), Node::UnitZ()));
    if (dimension_ == 3)
      turn = Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                                random.uniform(-1, 1))
                 .normalized();
    const Node middle(0.5, 0.5, dimension_ == 3 ? 0.5 : 0);
    for (Node& node : words.nodes) node = turn * (node - middle);
    size_ = 1.0 / count;
    Triple at = place;
    if (dimension_ == 2) at[2] = 0;
    return scene_.add_mesh(words, at);
  }
  Node momentum() const {
    Node sum = Node::Zero();
    for (const hs_body body : bodies_) sum += Eigen::Map<const Node>(scene_.body_state(body).momentum);
    return sum;
  }
  double deepest() const {
    std::vector<std::pair<hs_body, Simplex>> cells;
    std::vector<hs_block> blocks(static_cast<std::size_t>(scene_.report().block_count));
    scene_.check(hs_world_get_blocks(scene_.world(), blocks.data(), std::int64_t(blocks.size()), nullptr));
    for (const hs_block block : blocks) {
      Simplex corners = Simplex::Zero(3, dimension_ + 1);
      scene_.check(hs_world_get_block_vertices(
          scene_.world(), block,
          {&corners(0, 0), &corners(1, 0), &corners(2, 0), 3 * sizeof(double), dimension_ + 1}, nullptr));
      cells.emplace_back(scene_.body_of(block), corners);
    }
    double deepest = 0;
    for (const auto& [body, cell] : cells) {
      for (const auto& [other, corners] : cells) {
        if (body == other) continue;
        for (int i = 0; i <= dimension_; ++i)
          deepest = std::max(deepest, depth_in(cell, dimension_, corners.col(i)));
      }
    }
    return deepest / size_;
  }

  int dimension_;
  ReactingScene scene_;
  std::array<hs_body, 2> bodies_{};
  double size_ = 0;
};

}  // namespace

TEST_CASE("random bodies never go into each other without a spring", "[mesh][reaction]") {
  for (const int32_t kind : {HS_CELL_QUAD, HS_CELL_TRIANGLE, HS_CELL_HEXAHEDRON, HS_CELL_TETRAHEDRON}) {
    for (const double friction : {0.0, 0.4}) {
      Outcome worst;
      const unsigned runs = dimension_of(kind) == 2 ? 20 : 6;
      for (unsigned seed = 1; seed <= runs; ++seed) {
        INFO(name_of_cell(kind) << ", friction " << friction << ", seed " << seed);
        const Outcome outcome = Collision(kind, friction, seed).run();
        CHECK(outcome.deepest < 1e-6);
        CHECK(outcome.most_energy < 1 + 1e-6);
        CHECK(outcome.momentum_error < 1e-13);
        worst.deepest = std::max(worst.deepest, outcome.deepest);
        worst.most_energy = std::max(worst.most_energy, outcome.most_energy);
      }
      std::printf(
          "%u random pairs of %s, friction %.1f: deepest node %.1e of an element, most energy 1 %+.1e\n",
          runs, name_of_cell(kind), friction, worst.deepest, worst.most_energy - 1);
    }
  }
}
