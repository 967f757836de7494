// Sequences of world calls: one that fails changes nothing, nothing that moves is ever no number, and every
// history restores to the bit. For that each sequence is run twice, the second time on a world that is
// queried and restored from its own snapshot between the calls.

#include "capi/snapshot_worlds.h"
#include "fuzz/load_calls.h"

namespace halfspace_fuzz {
namespace {

constexpr int most_blocks = 8;
/// Bytes below choose among the calls of blocks, 17 of them one after the other.
constexpr int first_call_of_bodies = 221;
constexpr int first_call_of_loads = 246;

hs_world_def read_world_def(Bytes& bytes, int dimension) {
  hs_world_def def = world_def(dimension);
  if (bytes.flag()) read_into(def.gravity, bytes, dimension);
  if (bytes.below(4) == 0) def.time_step = bytes.positive() / 4096;
  if (bytes.flag()) return def;
  def.safety = bytes.positive_or(def.safety);
  def.local_damping = bytes.positive_or(0);
  def.mass_damping = bytes.positive_or(0);
  def.skin = bytes.positive_or(def.skin);
  def.parallel_angle = bytes.positive_or(def.parallel_angle);
  def.vertex_zone = bytes.positive_or(def.vertex_zone);
  def.potential_length = bytes.positive_or(0);
  def.fast_blocks = bytes.below(3);
  def.sleep_tolerance = bytes.positive_or(0);
  return def;
}

hs_law_def read_law(Bytes& bytes) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.stiffness_kind = bytes.below(4);
  law.normal_stiffness = 1024 * bytes.positive();
  if (bytes.flag()) law.shear_stiffness = 1024 * bytes.positive();
  if (bytes.flag()) law.friction_angle = bytes.below(90) / 57.3;
  if (bytes.flag()) return law;
  law.cohesion = bytes.positive_or(0);
  law.tensile_strength = bytes.positive_or(0);
  law.normal_damping = bytes.positive_or(law.normal_damping);
  law.shear_damping = bytes.positive_or(law.shear_damping);
  return law;
}

/// The snapshot after each call, as its checksum; 0 within a step in pieces.
using History = std::vector<std::uint64_t>;

class Calls : LoadCalls {
 public:
  Calls(Bytes bytes, hs_context* context) : LoadCalls(bytes, context) {
    dimension_ = bytes_.between(2, 3);
    const hs_world_def def = read_world_def(bytes_, dimension_);
    hs_world* world = nullptr;
    if (!succeeds_or(hs_world_create(context, &def, &world), {HS_ERROR_ARGUMENT}, "create")) return;
    world_ = World(world);
    add_material();
    set_law();
    for (int blocks = bytes_.between(1, 3); blocks > 0; --blocks) add_block();
  }

  History run() {
    History history;
    while (world_ && !bytes_.empty()) {
      call_by(bytes_.byte());
      check_motion(world());
      check_forces(world());
      check_bodies(world(), bodies_);
      history.push_back(checksum());
    }
    return history;
  }

  /// The same calls, with queries and restored worlds between them.
  void run_again(const History& history) {
    for (const std::uint64_t expected : history) {
      check_queries(world());
      call_by(bytes_.byte());
      demand(checksum() == expected, "queries and restored worlds change no history");
      if (expected != 0 && !may_be_planned_) world_ = restored(context_, saved(world()));
    }
  }

 private:
  std::uint64_t checksum() const {
    const std::vector<unsigned char> bytes = saved_between_steps(world());
    return bytes.empty() ? 0 : at<std::uint64_t>(bytes, 24);
  }

  void call_by(int byte) {
    if (byte < first_call_of_bodies) {
      call(byte % 17);
    } else if (byte < first_call_of_loads) {
      call_of_bodies(byte - first_call_of_bodies);
    } else {
      call_of_loads(byte - first_call_of_loads);
    }
  }

  void call_between_pieces(int byte) override { call(byte % 17); }

  void call(int which) {
    switch (which) {
      case 0:
        return add_block();
      case 1:
        return remove_block();
      case 2:
        return set_pose();
      case 3:
        return set_velocity();
      case 4:
        return set_law();
      case 5:
        return add_material();
      case 6:
        return set_elasticity();
      case 7:
        return set_deformation();
      case 8:
        return set_stress();
      case 9:
        return add_surface_load();
      case 10:
        return apply_force();
      case 11:
        return detect_and_find_forces();
      case 12:
        return preload();
      case 13:
        return check_report(world());
      case 14:
        return go_on_from_snapshot();
      default:
        return step_some();
    }
  }

  void add_block() {
    if (blocks_of(world()).size() >= most_blocks + 12 * bodies_.size()) return;
    const Shape shape = read_hull(bytes_, context_, dimension_);
    if (!shape) return;
    hs_block_def def;
    hs_block_def_init(&def, sizeof def, shape.get());
    static constexpr std::int32_t kinds[] = {HS_BLOCK_RIGID,      HS_BLOCK_FIXED, HS_BLOCK_AFFINE,
                                             HS_BLOCK_PRESCRIBED, HS_BLOCK_RIGID, 4};
    def.kind = kinds[bytes_.below(6)];
    def.material = bytes_.below(3);
    if (bytes_.flag()) def.pose = read_pose(bytes_, dimension_);
    if (bytes_.flag()) read_into(def.velocity, bytes_, dimension_);
    if (bytes_.flag()) read_into(def.angular_velocity, bytes_, 3);
    hs_block block = 0;
    if (unless_refused("add_block", [&] { return hs_world_add_block(world(), shape.get(), &def, &block); }))
      ids_.push_back(block);
  }

  void remove_block() {
    const hs_block block = any_block();
    unless_refused("remove_block", [&] { return hs_world_remove_block(world(), block); });
  }

  void set_pose() {
    const hs_block block = any_block();
    const hs_pose pose = read_pose(bytes_, dimension_);
    unless_refused("set_pose", [&] { return hs_world_set_pose(world(), block, &pose); });
  }

  void set_velocity() {
    const hs_block block = any_block();
    double velocity[3], angular[3];
    read_into(velocity, bytes_, dimension_);
    read_into(angular, bytes_, 3);
    unless_refused("set_velocity", [&] { return hs_world_set_velocity(world(), block, velocity, angular); });
  }

  void set_law() {
    const hs_law_def law = read_law(bytes_);
    const int a = bytes_.below(4), b = bytes_.below(4);
    unless_refused("set_law", [&] {
      return a == 0 ? hs_world_set_default_law(world(), &law) : hs_world_set_law(world(), a - 1, b, &law);
    });
  }

  void add_material() {
    const double density = bytes_.positive();
    std::int32_t material = 0;
    unless_refused("add_material", [&] { return hs_world_add_material(world(), density, &material); });
  }

  void set_elasticity() {
    const int material = bytes_.below(3);
    hs_elasticity_def def = elasticity_def(4096 * bytes_.positive(), bytes_.positive_or(0) / 4096);
    if (bytes_.flag()) def.poisson_ratio = bytes_.below(64) / 100.0 - 0.1;
    def.plane = bytes_.below(2);
    unless_refused("set_elasticity", [&] { return hs_world_set_elasticity(world(), material, &def); });
  }

  void set_deformation() {
    const hs_block block = any_block();
    double gradient[9], rate[9];
    for (int i = 0; i < 9; ++i) gradient[i] = (i % 4 == 0 ? 1 : 0) + bytes_.number() / 256;
    for (double& r : rate) r = bytes_.number();
    unless_refused("set_deformation",
                   [&] { return hs_world_set_deformation(world(), block, gradient, rate); });
  }

  void set_stress() {
    const hs_block block = any_block();
    const double xx = bytes_.number(), yy = bytes_.number(), zz = bytes_.number(), xy = bytes_.number();
    const double stress[9] = {xx, xy, 0, xy, yy, 0, 0, 0, zz};
    unless_refused("set_stress", [&] { return hs_world_set_stress(world(), block, stress); });
  }

  void add_surface_load() {
    const hs_block block = any_block();
    const int face = bytes_.below(8);
    double traction[3];
    read_into(traction, bytes_, dimension_);
    unless_refused("surface load", [&] {
      return face == 7 ? hs_world_clear_surface_loads(world(), block)
                       : hs_world_add_surface_load(world(), block, face, traction);
    });
  }

  void apply_force() {
    const hs_block block = any_block();
    double force[3], torque[3];
    read_into(force, bytes_, dimension_);
    read_into(torque, bytes_, 3);
    unless_refused("set_applied_force",
                   [&] { return hs_world_set_applied_force(world(), block, force, torque); });
  }

  void detect_and_find_forces() {
    std::int64_t touching = 0;
    unless_refused("detect", [&] { return hs_world_detect(world(), &touching); });
    demand(touching >= 0, "contacts are counted");
    const double elapsed = bytes_.positive_or(0);
    Points3 forces(blocks_of(world()).size()), torques = forces;
    if (!unless_refused("forces", [&] {
          return hs_world_forces(world(), elapsed, mutable_view_of(forces), mutable_view_of(torques));
        }))
      return;
    for (const Points3* sums : {&forces, &torques})
      for (const Point3& f : *sums)
        demand(std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z), "forces are numbers");
  }

  void preload() {
    const hs_block a = any_block(), b = any_block();
    double force[3];
    read_into(force, bytes_, 3);
    unless_refused("set_shear_force", [&] { return hs_world_set_shear_force(world(), a, b, force); });
  }

  void step_some() {
    const int steps = std::min(bytes_.below(12), max_steps - steps_);
    steps_ += steps;
    may_be_planned_ = false;
    if (!step(world(), steps)) steps_ = max_steps;  // one that is divided very often would be so again
  }

  /// A world and what is restored of its bytes do the same from there, whether or not one of them is asked
  /// for a report.
  void go_on_from_snapshot() {
    if (saved_between_steps(world()).empty()) return;
    const World twin = restored(context_, saved(world()));
    demand(saved(twin.get()) == saved(world()), "a restored world is the one that was saved");
    if (bytes_.flag()) check_report(twin.get());
    const int steps = std::min(bytes_.between(1, 4), max_steps - steps_);
    if (steps <= 0) return;
    steps_ += steps;
    const bool one = step(world(), steps), other = step(twin.get(), steps);
    if (!one) steps_ = max_steps;
    demand(one == other, "a restored world goes on as the one that was saved");
    demand(saved(twin.get()) == saved(world()), "a restored world goes on bit for bit");
  }
};

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const halfspace_test::Context context = halfspace_test::make_context();
  const halfspace_fuzz::History history = halfspace_fuzz::Calls({data, size}, context.get()).run();
  halfspace_fuzz::Calls({data, size}, context.get()).run_again(history);
  return 0;
}
