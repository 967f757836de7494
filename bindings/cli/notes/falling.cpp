#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "common/text.h"
#include "common/vector.h"
#include "notes/assembly.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// Connected blocks without a support.
struct Cluster {
  std::vector<std::size_t> blocks;
  std::size_t objects = 0;  ///< blocks and whole bodies
  bool is_thrown = false;   ///< it has a velocity at the start
  double thickness = 0;     ///< of its thickest block
  double volume = 0;
  double mass = 0;
};

class Falling {
 public:
  Falling(const Start& start, const Point& gravity, Faults& faults)
      : start_(start), gravity_(gravity), faults_(faults), assembly_(start) {
    for (const std::size_t other : {1, 2})
      if (std::abs(gravity[other]) > std::abs(gravity[axis_])) axis_ = other;
    const int all_axes = HS_AXIS_X | HS_AXIS_Y | HS_AXIS_Z;
    is_held_ = assembly_.held_blocks(length(gravity) > 0 ? 1 << axis_ : all_axes);
    is_gone_.assign(is_held_.size(), 0);
    for (const SceneStage& stage : start.scene.stages) settles_ = settles_ || stage.settles;
  }

  void note_at_start() {
    const std::vector<Cluster> clusters = loose_clusters();
    if (std::none_of(is_held_.begin(), is_held_.end(), [](char is_held) { return is_held != 0; })) {
      note_no_support(clusters);
      return;
    }
    std::set<std::string> noted;  // once for each table of the file
    for (const Cluster& cluster : clusters) {
      const LayoutBlock& block = first_of(cluster);
      if (noted.contains(block.key) || cluster.is_thrown || is_carried(cluster) || !falls_far(cluster))
        continue;
      const double gap = gap_below(cluster);
      std::string text;
      if (gap == std::numeric_limits<double>::infinity()) {
        text = " out of the scene; usual: a fixed, prescribed or supported block below";
      } else if (is_gap(cluster, gap)) {
        text = " " + rounded(gap, 3) + " m at the start, onto the nearest support; usual: no gap below";
      } else {
        continue;
      }
      noted.insert(block.key);
      faults_.note(block.place, block.key, described(cluster) + text);
    }
  }

  void excavate(std::size_t stage) {
    const std::vector<std::size_t>& taken = start_.layout.excavated[stage];
    if (taken.empty()) return;
    const bool was_gone =
        std::any_of(taken.begin(), taken.end(), [&](std::size_t i) { return is_gone_[i] != 0; });
    if (was_gone) note_stage(stage, "excavates blocks that an earlier stage has excavated");
    std::set<std::size_t> loose_before;
    for (const Cluster& cluster : loose_clusters())
      loose_before.insert(cluster.blocks.begin(), cluster.blocks.end());
    for (const std::size_t i : taken) is_gone_[i] = 1;
    if (nothing_moves()) {
      note_stage(stage, "excavates all free blocks");
      return;
    }
    std::size_t count = 0;
    std::string first;
    for (const Cluster& cluster : loose_clusters()) {
      const LayoutBlock& block = first_of(cluster);
      if (loose_before.contains(cluster.blocks[0])) continue;
      const bool is_part = block.body && is_part_of_body(cluster);
      if (!is_part && gap_below(cluster) < std::numeric_limits<double>::infinity()) continue;
      if (count == 0) first = block.name;
      count += cluster.blocks.size();
    }
    if (count > 0)
      note_stage(stage, "leaves " + counted(count, "block") + " without support, such as " + quoted(first));
  }

 private:
  std::vector<Cluster> loose_clusters() const {
    const std::vector<std::size_t> first = assembly_.clusters(is_gone_);
    std::vector<char> holds(first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
      if (is_held_[i] && !is_gone_[i]) holds[first[i]] = 1;
    std::vector<std::size_t> cluster_of(first.size());
    std::vector<Cluster> clusters;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (is_gone_[i] || holds[first[i]]) continue;
      if (first[i] == i) {
        cluster_of[i] = clusters.size();
        clusters.emplace_back();
      }
      Cluster& cluster = clusters[cluster_of[first[i]]];
      const LayoutBlock& block = start_.layout.blocks[i];
      const auto is_one_with = [&](const LayoutBlock& other) {
        return (block.body || block.compound) && block.body == other.body && block.compound == other.compound;
      };
      const bool is_new = cluster.blocks.empty() || !is_one_with(start_.layout.blocks[cluster.blocks.back()]);
      cluster.objects += is_new;
      cluster.is_thrown = cluster.is_thrown || length(point_of(start_.bodies[i].state.velocity)) > 0;
      cluster.thickness = std::max(cluster.thickness, start_.bodies[i].thickness);
      cluster.volume += start_.bodies[i].volume;
      cluster.mass +=
          start_.bodies[i].volume * start_.scene.materials[static_cast<std::size_t>(block.material)].density;
      cluster.blocks.push_back(i);
    }
    return clusters;
  }

  /// True if the cluster would fall by a hundredth of its thickness within the scene.
  bool falls_far(const Cluster& cluster) const {
    const double time = start_.scene.duration;
    return settles_ || 0.5 * length(gravity_) * time * time >= 0.01 * cluster.thickness;
  }

  /// True if water of the scene, which is somewhere below all places, carries the cluster.
  bool floats(const Cluster& cluster) const {
    const auto carries = [&](const std::optional<Water>& water) {
      return water && cluster.mass < water->def.factor * water->def.density * cluster.volume;
    };
    const auto& stages = start_.scene.stages;
    return carries(start_.scene.water) ||
           std::any_of(stages.begin(), stages.end(),
                       [&](const SceneStage& stage) { return carries(stage.water); });
  }

  /// True if loads on the faces of its meshes bear the weight of the cluster, as below a base that waves
  /// leave.
  bool is_borne_by_loads(const Cluster& cluster) const {
    double upward = 0;
    for (const LayoutBody& body : start_.layout.bodies) {
      if (!std::binary_search(cluster.blocks.begin(), cluster.blocks.end(), body.first_block)) continue;
      for (const LayoutBody::Force& force : body.forces)
        upward -= dot(force.force, gravity_) / length(gravity_);
    }
    return upward >= 0.99 * cluster.mass * length(gravity_);
  }

  bool is_carried(const Cluster& cluster) const { return floats(cluster) || is_borne_by_loads(cluster); }

  void note_no_support(const std::vector<Cluster>& clusters) {
    const Cluster* lowest = nullptr;
    for (const Cluster& cluster : clusters) {
      if (cluster.is_thrown || is_carried(cluster) || !falls_far(cluster)) continue;
      if (!lowest || height(cluster) < height(*lowest)) lowest = &cluster;
    }
    if (!lowest) return;
    const LayoutBlock& block = first_of(*lowest);
    faults_.note(
        block.place, block.key,
        described(*lowest) +
            ": no block is fixed or prescribed, and no mesh is held along gravity; usual: a floor with "
            "kind = \"fixed\", or a [[mesh.support]]");
  }

  /// The height of the lowest point of a cluster.
  double height(const Cluster& cluster) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : cluster.blocks)
      for (const Point& p : assembly_.bodies()[i].vertices) lowest = std::min(lowest, -dot(p, gravity_));
    return lowest;
  }

  const LayoutBlock& first_of(const Cluster& cluster) const {
    return start_.layout.blocks[cluster.blocks[0]];
  }

  std::string described(const Cluster& cluster) const {
    const std::string name = quoted(first_of(cluster).name);
    if (cluster.blocks.size() == 1) return name + " falls";
    return name + " and " + counted(cluster.blocks.size() - 1, "block") + " with it fall";
  }

  /// True for a gap below a pile, or below any cluster in a scene that settles.
  bool is_gap(const Cluster& cluster, double gap) const {
    constexpr double reported_fraction_of_height = 0.01;
    if (!settles_ && cluster.objects == 1) return false;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::size_t i : cluster.blocks) {
      for (const Point& p : assembly_.bodies()[i].vertices) {
        low = std::min(low, dot(p, gravity_) / length(gravity_));
        high = std::max(high, dot(p, gravity_) / length(gravity_));
      }
    }
    return gap > reported_fraction_of_height * (high - low);
  }

  /// The highest and the lowest point of a body's box, as downward coordinates.
  std::pair<double, double> downwards(const ConvexBody& body) const {
    if (gravity_[axis_] > 0) return {body.low[axis_], body.high[axis_]};
    return {-body.high[axis_], -body.low[axis_]};
  }

  /// True if the boxes overlap across gravity, so that one body is below the other.
  bool overlap_across(const ConvexBody& a, const ConvexBody& b) const {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(start_.layout.dimension); ++axis)
      if (axis != axis_ && !(a.low[axis] < b.high[axis] && b.low[axis] < a.high[axis])) return false;
    return true;
  }

  /// The distance to the highest support below, by boxes; infinite without a support.
  double gap_below(const Cluster& cluster) const {
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < is_held_.size(); ++j) {
      if (!is_held_[j] || is_gone_[j]) continue;
      const auto [top, bottom] = downwards(assembly_.bodies()[j]);
      for (const std::size_t i : cluster.blocks) {
        const double lowest = downwards(assembly_.bodies()[i]).second;
        if (bottom > lowest && overlap_across(assembly_.bodies()[j], assembly_.bodies()[i]))
          gap = std::min(gap, std::max(0.0, top - lowest));
      }
    }
    return gap;
  }

  bool is_part_of_body(const Cluster& cluster) const {
    const LayoutBody& body = start_.layout.bodies[*first_of(cluster).body];
    const std::set<std::size_t> own(cluster.blocks.begin(), cluster.blocks.end());
    for (std::size_t cell = body.first_block; cell < body.first_block + body.cell_nodes.size(); ++cell)
      if (!is_gone_[cell] && !own.contains(cell)) return true;
    return false;
  }

  bool nothing_moves() const {
    for (std::size_t i = 0; i < is_gone_.size(); ++i)
      if (!is_gone_[i] && moves_freely(start_.layout.blocks[i].kind)) return false;
    return true;
  }

  void note_stage(std::size_t stage, const std::string& text) {
    faults_.note(start_.scene.stages[stage].excavated_place, "stage[" + std::to_string(stage) + "].excavate",
                 text);
  }

  const Start& start_;
  Point gravity_;
  std::size_t axis_ = 0;  ///< nearest to gravity
  Faults& faults_;
  Assembly assembly_;
  std::vector<char> is_held_, is_gone_;
  bool settles_ = false;
};

/// Gravity of the scene, or of the first stage that has some.
Point gravity_of(const Scene& scene) {
  const Point gravity = point_of(scene.world.gravity);
  if (length(gravity) > 0) return gravity;
  for (const SceneStage& stage : scene.stages)
    if (stage.gravity && length(*stage.gravity) > 0) return *stage.gravity;
  return gravity;
}

/// Notes unbalanced loads on meshes without supports.
void note_loads(const Start& start, Faults& faults) {
  for (const LayoutBody& body : start.layout.bodies) {
    Point sum{};
    double all = 0;
    for (const LayoutBody::Force& force : body.forces) {
      sum = plus(sum, force.force);
      all += length(force.force);
    }
    if (!body.supports.empty() || !(length(sum) > 1e-6 * all)) continue;
    const LayoutBlock& block = start.layout.blocks[body.first_block];
    faults.note(block.place, block.key,
                quoted(block.name) + " has no support against its loads, " + rounded(length(sum), 3) +
                    " N in all; usual: a [[mesh.support]]");
  }
}

}  // namespace

void note_falling(const Start& start, Faults& faults) {
  const Point gravity = gravity_of(start.scene);
  if (length(gravity) == 0) note_loads(start, faults);
  if (start.layout.blocks.size() > max_compared_blocks) return;
  Falling falling(start, gravity, faults);
  if (length(gravity) > 0) falling.note_at_start();
  for (std::size_t stage = 0; stage < start.scene.stages.size(); ++stage) falling.excavate(stage);
}

}  // namespace halfspace::cli
