#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/archive.h"
#include "model/carried_point.h"
#include "model/layout.h"
#include "model/library.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// One block, or cell of a mesh, at one time.
struct BlockFrame {
  hs_block_state state{};
  hs_deformation deformation{};  ///< of blocks that deform
  std::vector<Point> vertices;   ///< current positions, counter-clockwise
};

/// True for an excavated block.
inline bool is_removed(const BlockFrame& block) { return block.vertices.empty(); }

/// All blocks at one time, in the order of the layout.
struct Frame {
  double time = 0;
  std::vector<BlockFrame> blocks;
  std::vector<hs_contact> contacts;  ///< with indices of blocks; only if the output has contacts
  std::vector<hs_bolt> bolts;        ///< their numbers are indices of the scene's bolts
  std::vector<Point> water;          ///< corners of the water table; empty without water
};

/// The world of a scene, and the motions that start and stop in it.
class Model {
 public:
  Model(const Context& context, const Scene& scene, Layout layout);

  static constexpr double never = std::numeric_limits<double>::infinity();

  /// Steps the world to the step nearest to a time, or to the next start or stop of a prescribed motion, by
  /// at most `max_steps` steps. The last one or two steps before `end` are shortened to meet it exactly.
  /// @throws LibraryError
  void step_towards(double time, std::int64_t max_steps, double end = never);
  /// True once such an end is met.
  bool has_met(double end) const { return end - report_.time <= time_tolerance(end); }

  /// Begins a stage that excavates these blocks. Its gradual changes are applied by change_to().
  void begin(const SceneStage& stage, const std::vector<std::size_t>& excavated);
  /// Sets the progress of the gradual changes, from 0 to 1: gravity, mesh loads, and the support of excavated
  /// cells.
  void change_to(double progress);
  /// The actions that begin with a stage, as text to compare.
  std::string actions_of(std::size_t stage) const;
  bool is_changed() const { return state_.progress == 1; }
  /// Brings the world to rest; false if the max number of steps does not suffice. @throws LibraryError
  bool settle(const hs_relaxation_def& relaxation, hs_balance& balance);

  /// The world as hs_world_save() writes it.
  std::string snapshot() const;
  /// Adds the state of a run to an archive, or restores it. @throws LibraryError, std::runtime_error
  void add_to(Archive& archive);

  hs_world* world() const { return world_.get(); }
  /// Hands the world over; the model has none from then on.
  World release_world() { return std::move(world_); }
  /// The name of each block of the world, cells included, in the order of hs_world_get_blocks().
  std::vector<std::string> names() const;
  /// The library's text of an error, with the names of blocks for their ids.
  std::string with_names(const std::string& text) const;

  /// Replaces the time step that the scene gives, s.
  void set_time_step(double time_step);
  /// Divides all strengths of the scene by a factor.
  void weaken(double factor);
  /// Turns gravity, also while a stage changes it, about an axis of unit length, by an angle in rad.
  void tilt(const Point& axis, double angle);

  /// True after the step nearest to this time.
  bool reached(double time) const { return time - report_.time < report_.time_step / 2; }

  /// Does a prescribed motion still start or stop?
  bool has_motion_changes() const { return next_motion_change() != never; }
  bool motions_over() const { return !has_motion_changes() && reached(state_.actions_end); }
  const hs_world_report& report() const { return report_; }
  Frame frame() const;
  /// The current contacts; their blocks are indices in the layout.
  std::vector<hs_contact> contacts() const;
  /// All bonds; their blocks are indices in the layout.
  std::vector<hs_bond> bonds() const;
  /// The installed bolts; their numbers are indices of the scene's bolts.
  std::vector<hs_bolt> bolts() const;
  const Bolt& bolt(std::int64_t index) const { return given_bolts_[static_cast<std::size_t>(index)]; }
  /// The numbers of bonds and of their failures.
  hs_bond_report bond_report() const;
  /// The two blocks of a bond, as indices in the layout; bonds in the order of their creation.
  const std::pair<std::size_t, std::size_t>& blocks_of_bond(std::size_t bond) const { return bonded_[bond]; }
  /// All failures of bonds so far.
  std::vector<hs_bond_event> bond_events() const;
  hs_block_state state_of(std::size_t block) const;
  /// The same with its deformation.
  BlockFrame motion_of(std::size_t block) const;
  /// A point of a block, from its position now; the block has not strained yet.
  CarriedPoint carry(std::size_t block, const Point& at) const;
  /// Its position at the time of a frame, and its velocity now; NaN if its block is excavated.
  Point position_of(const CarriedPoint& point, const BlockFrame& block) const;
  Point position_of(const CarriedPoint& point) const { return position_of(point, motion_of(point.block)); }
  Point velocity_of(const CarriedPoint& point) const;
  /// The active parts of the world, and the cost of so many steps, measured on a copy.
  hs_world_plan account(std::int64_t steps) const;
  /// The index in the layout of a block of the world, of the first part of a compound, or of a cell of a
  /// body.
  std::size_t index_of(hs_block block) const;
  std::size_t index_of(hs_body body, int32_t cell) const {
    return layout_.bodies[index_of_body_.at(body)].first_block + static_cast<std::size_t>(cell);
  }
  /// The block that contains a place, as an index in the layout.
  std::optional<std::size_t> block_at(const Point& place) const;
  const Layout& layout() const { return layout_; }

 private:
  std::string name(hs_block block) const;
  void preload_joints(const Scene& scene);
  void add(const LayoutBody& body, const std::vector<Material>& materials);
  void make_viscous(const LayoutBody& given, hs_body body, const std::vector<Material>& materials);
  void add(const LayoutCompound& compound);
  void excavate(const std::vector<std::size_t>& blocks);
  bool has_parts_of_layout() const;
  bool has_block_of_layout(std::size_t block) const;
  bool has_body_of_layout(std::size_t body) const;
  bool is_of_layout(hs_block block) const;
  /// True if all cells of a body are excavated.
  bool is_excavated(std::size_t body) const;
  void excavate_cells(std::size_t body, const std::vector<int32_t>& cells);
  void load_nodes(std::size_t body);
  std::optional<Water> water() const;
  void set_water();
  void set_gravity();
  void prepare_bolts();
  void install(std::size_t bolt);
  hs_block block_at_end(std::size_t index, std::size_t end) const;
  hs_block named_block(const Bolt& bolt, std::size_t end) const;
  bool has_bolts_of_scene() const;
  /// The cells of a body, as blocks.
  std::vector<BlockFrame> frame_of(std::size_t body) const;
  /// Begins the actions of a stage.
  void begin_actions(std::size_t stage);
  int32_t add_table(const TimeTable& table);
  /// Restores a world from snapshot(). @throws LibraryError
  void restore(const std::string& world);
  void note_motions();
  void set_due_motions();
  struct PrescribedBlock {
    std::size_t index = 0;  ///< in the layout; of a compound its first part
    hs_block block = 0;
  };
  std::vector<PrescribedBlock> prescribed_blocks() const;
  /// True between the start and the stop of the motion of a prescribed block.
  bool moves(std::size_t block) const;
  double next_motion_change() const;
  void update_report();
  /// The time step without shortening; 0 while it is unknown.
  double usual_time_step() const;
  void step_shortened(double length);
  /// Differences of times below this are ignored: rounding, and small fractions of a step.
  double time_tolerance(double end) const;

  const Context& context_;
  Layout layout_;
  std::vector<Action> actions_;  ///< of the scene
  World world_;
  std::vector<hs_block> blocks_;  ///< 0: a cell of a body
  std::vector<hs_block> compounds_;
  std::vector<hs_body> bodies_;
  std::map<hs_block, std::size_t> index_of_block_;
  std::map<hs_block, std::size_t> index_of_compound_;
  std::map<hs_body, std::size_t> index_of_body_;
  std::vector<double> densities_;  ///< of the materials
  hs_world_report report_{};
  /// The quantities that stages change.
  struct State {
    Point gravity{};
    Point gravity_before{};
    double loads = 1;  ///< factor of the scene's mesh loads
    double loads_before = 1;
    double progress = 1;  ///< of the change, from 0 to 1
    double local_damping = 0;
    double mass_damping = 0;
    double usual_time_step = 0;  ///< after a shortened step
    double actions_end = 0;      ///< s, when the last table is over
  };
  State state_;
  std::optional<Water> water_, water_before_;  ///< at the end and at the start of the gradual changes
  std::vector<Bolt> given_bolts_;
  std::vector<std::int64_t> bolt_numbers_;  ///< of each given bolt in the world; -1: not installed yet
  double given_time_step_;                  ///< by the scene, or 0
  double safety_;
  std::vector<std::pair<std::size_t, std::size_t>> bonded_;  ///< the two blocks of each bond
  std::vector<char> is_moving_;               ///< prescribed blocks that have started and not stopped
  std::vector<char> is_removed_;              ///< of each block: 0, 1 excavated, 2 by the current stage
  std::vector<std::vector<Point>> released_;  ///< forces of excavated cells on each body's nodes, or none
  bool frames_have_contacts_;
};

/// How much of its gradual changes a stage that runs, and began at `start`, has made by now.
inline double progress_of(const SceneStage& stage, const Model& model, double start) {
  if (stage.ramp == 0 || model.reached(start + stage.ramp)) return 1;
  return (model.report().time - start) / stage.ramp;
}

/// True if a stage that runs, and began at `start`, has ended.
inline bool has_ended(const SceneStage& stage, const Model& model, double start) {
  const double end = start + stage.duration;
  return stage.ends_exactly ? model.has_met(end) : model.reached(end);
}

}  // namespace halfspace::cli
