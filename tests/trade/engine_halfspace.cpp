#include <halfspace/halfspace.h>

#include <cmath>
#include <map>

#include "benchmarks/timing.h"
#include "capi/handles.h"
#include "engine.h"

namespace halfspace_trade {
namespace {

using halfspace_benchmark::seconds_of;
using halfspace_test::require_ok;

constexpr double typical_size = 1;  // m; H of the potentials

struct Way {
  std::int32_t law;
  std::int32_t kind;
  double impulse_tolerance = 1e-6;
  std::int32_t max_iterations = 200;
};

const std::map<std::string, Way> ways = {
    {"per contact", {HS_STIFFNESS_PER_CONTACT, HS_BLOCK_RIGID}},
    {"per area", {HS_STIFFNESS_PER_AREA, HS_BLOCK_RIGID}},
    {"potential", {HS_STIFFNESS_POTENTIAL, HS_BLOCK_RIGID}},
    {"per contact, affine", {HS_STIFFNESS_PER_CONTACT, HS_BLOCK_AFFINE}},
    {"no springs", {HS_STIFFNESS_NONE, HS_BLOCK_RIGID}},
    {"no springs, tolerance 1e-3", {HS_STIFFNESS_NONE, HS_BLOCK_RIGID, 1e-3}},
    {"no springs, tolerance 1e-2", {HS_STIFFNESS_NONE, HS_BLOCK_RIGID, 1e-2}},
    {"no springs, 20 iterations", {HS_STIFFNESS_NONE, HS_BLOCK_RIGID, 1e-6, 20}},
    {"no springs, 4 iterations", {HS_STIFFNESS_NONE, HS_BLOCK_RIGID, 1e-6, 4}},
};

bool has_springs(const Way& way) { return way.law != HS_STIFFNESS_NONE; }

hs_law_def law_of(const Scene& scene, const Way& way, double stiffness) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  const double per_area = stiffness / typical_body(scene).size[0];
  law.stiffness_kind = way.law;
  law.shear_stiffness = stiffness;
  law.normal_stiffness = stiffness;
  if (way.law == HS_STIFFNESS_PER_AREA) law.normal_stiffness = law.shear_stiffness = per_area;
  if (way.law == HS_STIFFNESS_POTENTIAL) law.normal_stiffness = per_area * typical_size / 2;
  law.friction_angle = std::atan(scene.friction);
  if (!has_springs(way)) law.restitution = scene.restitution;
  law.normal_damping = law.shear_damping = scene.damping;
  return law;
}

class HalfspaceWorld : public World {
 public:
  HalfspaceWorld(const Scene& scene, const Setting& setting)
      : scene_(scene),
        way_(ways.at(setting.way)),
        stiffness_(has_springs(way_) ? face_stiffness(scene, setting.indentation) : 1),
        context_(halfspace_test::make_context()),
        time_step_(whole_part(scene.duration,
                              has_springs(way_) ? setting.step * stable_time_step() : setting.step)) {
    make(time_step_);
  }

  double step(long steps) override {
    return seconds_of([&] { require_ok(hs_world_step(world_.get(), steps), context_.get()); });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t body) const override {
    hs_block_state s;
    require_ok(hs_world_get_block_state(world_.get(), blocks_[body], &s), context_.get());
    State state;
    std::copy_n(s.pose.position, 3, state.position.begin());
    std::copy_n(s.pose.rotation, 4, state.rotation.begin());
    std::copy_n(s.velocity, 3, state.velocity.begin());
    std::copy_n(s.angular_velocity, 3, state.spin.begin());
    return state;
  }

 private:
  double stable_time_step() {
    make(0);
    hs_world_report report;
    require_ok(hs_world_get_report(world_.get(), &report, sizeof report), context_.get());
    return report.stable_time_step;
  }

  void make(double time_step) {
    hs_world_def def;
    hs_world_def_init(&def, sizeof def, scene_.dimension);
    std::copy(scene_.gravity.begin(), scene_.gravity.end(), def.gravity);
    def.time_step = time_step;
    def.potential_length = typical_size;
    def.impulse_tolerance = way_.impulse_tolerance;
    def.max_impulse_iterations = way_.max_iterations;
    def.locate_impacts = !has_springs(way_) && scene_.restitution > 0;
    hs_world* made = nullptr;
    require_ok(hs_world_create(context_.get(), &def, &made), context_.get());
    world_.reset(made);
    const hs_law_def law = law_of(scene_, way_, stiffness_);
    require_ok(hs_world_set_default_law(made, &law), context_.get());
    blocks_.clear();
    std::map<double, std::int32_t> materials;  // by density
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const auto [known, is_new] = materials.try_emplace(scene_.bodies[i].density);
      if (is_new) known->second = add_material(known->first);
      blocks_.push_back(add(i, known->second));
    }
    if (scene_.is_settled && has_springs(way_) && shear_load() > 0) set_shear();
  }

  std::int32_t add_material(double density) {
    std::int32_t material = 0;
    require_ok(hs_world_add_material(world_.get(), density, &material), context_.get());
    if (way_.kind == HS_BLOCK_AFFINE) make_elastic(material);
    return material;
  }

  /// The block itself gives as much as its contact does.
  void make_elastic(std::int32_t material) {
    hs_elasticity_def elasticity;
    hs_elasticity_def_init(&elasticity, sizeof elasticity);
    elasticity.young_modulus = stiffness_ / typical_size;
    elasticity.damping_time = scene_.damping * std::sqrt(density * typical_size / elasticity.young_modulus);
    require_ok(hs_world_set_elasticity(world_.get(), material, &elasticity), context_.get());
  }

  hs_block add(std::size_t i, std::int32_t material) {
    const Body& body = scene_.bodies[i];
    const std::vector<Vector> corners = corners_of(body, scene_.dimension);
    const hs_view view = {&corners[0][0], &corners[0][1], &corners[0][2], sizeof(Vector),
                          std::int64_t(corners.size())};
    hs_shape* made = nullptr;
    require_ok(scene_.dimension == 2 ? hs_polygon_create(context_.get(), view, &made)
                                     : hs_polyhedron_create_hull(context_.get(), view, &made),
               context_.get());
    const halfspace_test::Shape shape(made);
    hs_block_def def;
    hs_block_def_init(&def, sizeof def, made);
    def.kind = body.is_fixed ? std::int32_t(HS_BLOCK_FIXED) : way_.kind;
    def.material = material;
    std::copy(body.position.begin(), body.position.end(), def.pose.position);
    std::copy(body.rotation.begin(), body.rotation.end(), def.pose.rotation);
    std::copy(body.velocity.begin(), body.velocity.end(), def.velocity);
    std::copy(body.spin.begin(), body.spin.end(), def.angular_velocity);
    if (scene_.is_settled && has_springs(way_) && !body.is_fixed) settle(i, def.pose);
    hs_block block = 0;
    require_ok(hs_world_add_block(world_.get(), made, &def, &block), context_.get());
    return block;
  }

  /// The load of friction at the base, as far as friction can hold it.
  double shear_load() const {
    const double pull = mass_of(typical_body(scene_), scene_.dimension).mass * scene_.gravity[0];
    return std::min(pull, scene_.friction * scene_.load);
  }

  /// The springs below bear their loads; those of a single body on a slope the moment of the friction, too.
  void settle(std::size_t i, hs_pose& pose) const {
    const Body& body = scene_.bodies[i];
    const double height = body.size[std::size_t(scene_.dimension - 1)], width = body.size[0];
    const double moment = shear_load() * height / 2;
    const double springs_at =
        way_.law == HS_STIFFNESS_PER_CONTACT ? 4 : 12;  // the corners, or all over the face
    const double half = 0.5 * moment / (stiffness_ * width * width / springs_at);
    const double count = double(scene_.bodies.size() - 1);
    for (std::size_t below = 0; below < i; ++below)
      pose.position[scene_.dimension - 1] -= (1 - double(below) / count) * scene_.load / stiffness_;
    pose.rotation[scene_.dimension == 2 ? 2 : 1] = std::sin(scene_.dimension == 2 ? -half : half);
    pose.rotation[3] = std::cos(half);
  }

  void set_shear() {
    require_ok(hs_world_detect(world_.get(), nullptr), context_.get());
    const double friction[3] = {-shear_load(), 0, 0};
    require_ok(hs_world_set_shear_force(world_.get(), blocks_[0], blocks_[1], friction), context_.get());
  }

  Scene scene_;
  Way way_;
  double stiffness_;  // N/m of a face
  halfspace_test::Context context_;
  halfspace_test::World world_;
  std::vector<hs_block> blocks_;
  double time_step_;
};

}  // namespace

const char* engine_name() { return "halfspace"; }
bool knows_dimension(int) { return true; }
bool knows_hulls() { return true; }

std::vector<Setting> settings() {
  constexpr double usual = 0.5;
  std::vector<Setting> all =
      with_frame_steps({"no springs", "no springs, tolerance 1e-3", "no springs, tolerance 1e-2",
                        "no springs, 20 iterations", "no springs, 4 iterations"});
  for (const char* law : {"per contact", "per area", "potential"}) {
    for (const double indentation : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) all.push_back({law, indentation, usual});
    for (const double step : {1.0, 0.125}) all.push_back({law, 1e-4, step});
  }
  for (const double indentation : {1e-3, 1e-4}) all.push_back({"per contact, affine", indentation, usual});
  return all;
}

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<HalfspaceWorld>(scene, setting);
}

}  // namespace halfspace_trade
