#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "archive.h"
#include "layout.h"
#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// One block, or cell of a mesh, at one time.
struct BlockFrame {
  hs_block_state state{};
  hs_deformation deformation{};  ///< of a block that deforms
  std::vector<Point> vertices;   ///< counter-clockwise, where they are now
};

/// Was it excavated?
inline bool is_removed(const BlockFrame& block) { return block.vertices.empty(); }

/// All blocks at one time, in the order of the layout.
struct Frame {
  double time = 0;
  std::vector<BlockFrame> blocks;
  std::vector<hs_contact> contacts;  ///< of blocks by their indices; where the scene's output asks for them
};

/// The world of a scene, and the motions that start and stop in it.
class Model {
 public:
  Model(const Context& context, const Scene& scene, Layout layout);

  static constexpr double never = std::numeric_limits<double>::infinity();

  /// Steps the world, stopping on the way wherever a prescribed motion starts or stops, to the step nearest
  /// to a time. Does at most `max_steps` steps. Where there is an end, the last one or two before it are
  /// shortened so that it is met. @throws LibraryError
  void step_towards(double time, std::int64_t max_steps, double end = never);
  /// Has such an end been met?
  bool has_met(double end) const { return end - report_.time <= time_tolerance(end); }

  /// Changes the world as a stage says that excavates these blocks. What changes gradually is as before,
  /// until change_to() is called.
  void begin(const SceneStage& stage, const std::vector<std::size_t>& excavated);
  /// Gravity, the loads of meshes and what is excavated are so far on their way, from 0 to 1.
  void change_to(double share);
  bool is_changed() const { return state_.share == 1; }
  /// Brings the world to rest, in at most so many steps; true when it is. @throws LibraryError
  bool settle(const hs_relaxation_def& relaxation, hs_balance& balance);

  /// The world as hs_world_save() writes it.
  std::string snapshot() const;
  /// All that changes in a run. One that is read is where that was that was written. @throws LibraryError,
  /// std::runtime_error
  void add_to(Archive& archive);

  /// The world becomes the one that snapshot() has written. @throws LibraryError
  void restore(const std::string& world);
  /// All strengths are those of the scene divided by a factor.
  void weaken(double factor);

  /// Has the step nearest to this time been done?
  bool reached(double time) const { return time - report_.time < report_.time_step / 2; }

  bool motions_over() const { return next_motion_change() == never; }
  const hs_world_report& report() const { return report_; }
  Frame frame() const;
  /// The contacts there are; blocks are named by their indices in the layout.
  std::vector<hs_contact> contacts() const;
  /// The bonds made, and what has failed of them.
  hs_bond_report bond_report() const;
  /// The two blocks of a bond, in the order in which they were made, by their indices in the layout.
  const std::pair<std::size_t, std::size_t>& blocks_of_bond(std::size_t bond) const { return bonded_[bond]; }
  /// All that has failed of them so far.
  std::vector<hs_bond_event> bond_events() const;
  hs_block_state state_of(std::size_t block) const;
  /// The same with its deformation.
  BlockFrame motion_of(std::size_t block) const;
  /// The parts that the world computes, and the cost of so many steps of a copy of it.
  hs_world_plan account(std::int64_t steps) const;
  /// Where a block of the world stands in the layout, or a cell of a body.
  std::size_t index_of(hs_block block) const;
  std::size_t index_of(hs_body body, int32_t cell) const {
    return layout_.bodies[index_of_body_.at(body)].first_block + static_cast<std::size_t>(cell);
  }
  const Layout& layout() const { return layout_; }

 private:
  void add(const LayoutBody& body);
  void excavate(const std::vector<std::size_t>& blocks);
  bool has_parts_of_layout() const;
  bool has_block_of_layout(std::size_t block) const;
  bool has_body_of_layout(std::size_t body) const;
  bool is_of_layout(hs_block block) const;
  /// Are all of its cells gone?
  bool is_excavated(std::size_t body) const;
  void excavate_cells(std::size_t body, const std::vector<int32_t>& cells);
  void load_nodes(std::size_t body);
  /// The cells of a body, as blocks.
  std::vector<BlockFrame> frame_of(std::size_t body) const;
  void set_due_motions();
  double next_motion_change() const;
  void update_report();
  /// The length of a step that nothing shortens; 0 while it cannot be told.
  double usual_time_step() const;
  void step_shortened(double length);
  /// Rounding of so late a time, and what no step needs to be shortened by.
  double time_tolerance(double end) const;

  const Context& context_;
  Layout layout_;
  World world_;
  std::vector<hs_block> blocks_;  ///< 0: a cell of a body
  std::vector<hs_body> bodies_;
  std::map<hs_block, std::size_t> index_of_block_;
  std::map<hs_body, std::size_t> index_of_body_;
  std::vector<double> densities_;  ///< of the materials
  hs_world_report report_{};
  /// The things that stages change, and how far they are.
  struct State {
    Point gravity{};
    Point gravity_before{};
    double loads = 1;  ///< of meshes, as a share of the scene's
    double loads_before = 1;
    double share = 1;  ///< of the way from before
    double local_damping = 0;
    double mass_damping = 0;
    double usual_time_step = 0;  ///< after a step that was shortened
  };
  State state_;
  double given_time_step_;  ///< by the scene, or 0
  double safety_;
  std::vector<std::pair<std::size_t, std::size_t>> bonded_;  ///< the two blocks of each bond
  std::vector<char> is_removed_;  ///< of each block: 1, or 2 when the stage that takes it away has begun last
  std::vector<std::vector<Point>> released_;  ///< forces of excavated cells on each body's nodes, or none
  bool frames_have_contacts_;
};

/// Has a stage that runs, and began at this time, come to its end?
inline bool has_ended(const SceneStage& stage, const Model& model, double start) {
  const double end = start + stage.duration;
  return stage.ends_exactly ? model.has_met(end) : model.reached(end);
}

}  // namespace halfspace::cli
