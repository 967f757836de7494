// Definitions of callers that were compiled with an older or a later version of the headers, in every
// function that reads one.

#include <cstddef>
#include <cstring>
#include <memory>

#include "capi/action_world.h"
#include "catch.h"

namespace halfspace_test {
namespace {

using Bytes = std::vector<unsigned char>;

/// A definition in memory of exactly the size it says, so that reading past it is seen (by the address
/// sanitizer): the first bytes of `def`, and behind what is known the fields of a later version.
template <class Def>
class Resized {
 public:
  Resized(const Def& def, std::size_t size) : bytes_(new unsigned char[size]) {
    std::memset(bytes_.get(), 0x11, size);
    std::memcpy(bytes_.get(), &def, std::min(size, sizeof def));
    const auto said = static_cast<std::uint32_t>(size);
    std::memcpy(bytes_.get(), &said, sizeof said);
  }
  const Def* get() const { return reinterpret_cast<const Def*>(bytes_.get()); }

 private:
  std::unique_ptr<unsigned char[]> bytes_;
};

/// `use` says what comes of a definition. One cut off at any of `ends`, where its fields end, must count as
/// one whose other fields are the defaults; one with more fields as one without them.
template <class Def, class Use>
void check_sizes(const Def& defaults, const Def& chosen, const std::vector<std::size_t>& ends, Use use) {
  const Bytes whole = use(&chosen);
  const bool choices_count = whole != use(&defaults);
  CHECK(choices_count);
  for (const std::size_t size : {sizeof(Def) + 4, sizeof(Def) + 256}) {
    const bool as_without_them = use(Resized<Def>(chosen, size).get()) == whole;
    CHECK(as_without_them);
  }
  for (const std::size_t size : ends) {
    INFO("struct_size " << size);
    Def shortened = defaults;
    std::memcpy(static_cast<void*>(&shortened), &chosen, size);
    shortened.struct_size = defaults.struct_size;
    const bool as_with_defaults = use(Resized<Def>(chosen, size).get()) == use(&shortened);
    CHECK(as_with_defaults);
  }
}

template <class Value>
Bytes bytes_of(const Value& value) {
  Bytes bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

hs_law_def chosen_law() {
  hs_law_def law = law_def(2e7, 0.3);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  law.cohesion = 1e3;
  law.tensile_strength = 2e3;
  law.normal_damping = 0.1;
  law.shear_damping = 0.2;
  return law;
}

const std::vector<std::size_t> ends_of_law_fields = {
    offsetof(hs_law_def, normal_stiffness), offsetof(hs_law_def, shear_stiffness),
    offsetof(hs_law_def, friction_angle),   offsetof(hs_law_def, cohesion),
    offsetof(hs_law_def, tensile_strength), offsetof(hs_law_def, normal_damping),
    offsetof(hs_law_def, shear_damping)};

/// Checks a function that sets a law: what comes of it is the world, saved.
template <class Set>
void check_law(Set set) {
  hs_law_def defaults;
  REQUIRE(hs_law_def_init(&defaults, sizeof defaults) == HS_OK);
  check_sizes(defaults, chosen_law(), ends_of_law_fields, [&](const hs_law_def* law) {
    const TwoBoxes scene;
    require_ok(set(scene.world.get(), law), scene.context.get());
    return saved(scene.world.get());
  });
}

/// Two squares, one turned by half the parallel angle that is chosen: the contact depends on the options.
struct TiltedPair {
  Context context = make_context();
  Shape square = make_shape(context.get(), box(0, 0, 1, 1));
  hs_pose poses[2] = {pose_at(0, 0), pose_at(0, 0.99, 0.05, 0.9987492177719088)};

  hs_pair_options defaults() const {
    hs_pair_options options;
    require_ok(hs_pair_options_init(&options, sizeof options), context.get());
    return options;
  }
  hs_pair_options chosen() const {
    hs_pair_options options = defaults();
    options.parallel_angle = 0.2;
    options.vertex_zone = 0.4;
    options.margin = 1;
    return options;
  }
};

const std::vector<std::size_t> ends_of_option_fields = {offsetof(hs_pair_options, parallel_angle),
                                                        offsetof(hs_pair_options, vertex_zone),
                                                        offsetof(hs_pair_options, margin)};

}  // namespace

TEST_CASE("sizes of hs_world_def") {
  const hs_world_def defaults = world_def(3);
  hs_world_def chosen = defaults;
  chosen.gravity[0] = 1;
  chosen.time_step = 1e-3;
  chosen.safety = 0.25;
  chosen.local_damping = 0.5;
  chosen.mass_damping = 0.75;
  chosen.skin = 0.2;
  chosen.parallel_angle = 0.02;
  chosen.vertex_zone = 1e-3;
  chosen.potential_length = 0.3;
  chosen.fast_blocks = HS_FAST_REFUSE;
  chosen.sleep_tolerance = 1e-6;
  const std::vector<std::size_t> ends = {
      offsetof(hs_world_def, gravity),          offsetof(hs_world_def, time_step),
      offsetof(hs_world_def, safety),           offsetof(hs_world_def, local_damping),
      offsetof(hs_world_def, mass_damping),     offsetof(hs_world_def, skin),
      offsetof(hs_world_def, parallel_angle),   offsetof(hs_world_def, vertex_zone),
      offsetof(hs_world_def, potential_length), offsetof(hs_world_def, fast_blocks),
      offsetof(hs_world_def, sleep_tolerance)};
  check_sizes(defaults, chosen, ends, [](const hs_world_def* def) {
    const Context context = make_context();
    hs_world* world = nullptr;
    require_ok(hs_world_create(context.get(), def, &world), context.get());
    return saved(World(world).get());
  });
}

TEST_CASE("sizes of hs_law_def") {
  check_law(hs_world_set_default_law);
  check_law([](hs_world* world, const hs_law_def* law) { return hs_world_set_law(world, 0, 0, law); });
}

TEST_CASE("sizes of hs_elasticity_def") {
  hs_elasticity_def defaults;
  REQUIRE(hs_elasticity_def_init(&defaults, sizeof defaults) == HS_OK);
  hs_elasticity_def chosen = defaults;
  chosen.plane = HS_PLANE_STRESS;
  chosen.young_modulus = 3e9;
  chosen.poisson_ratio = 0.4;
  chosen.damping_time = 1e-5;
  const std::vector<std::size_t> ends = {offsetof(hs_elasticity_def, young_modulus),
                                         offsetof(hs_elasticity_def, poisson_ratio),
                                         offsetof(hs_elasticity_def, damping_time)};
  check_sizes(defaults, chosen, ends, [](const hs_elasticity_def* def) {
    const TwoBoxes scene;
    require_ok(hs_world_set_elasticity(scene.world.get(), scene.material, def), scene.context.get());
    return saved(scene.world.get());
  });
}

TEST_CASE("sizes of hs_block_def") {
  const Context context = make_context();
  const Shape shape = make_shape(context.get(), box(-1, -1, 1, 1));  // its default pose is that of no shape
  hs_block_def defaults;
  REQUIRE(hs_block_def_init(&defaults, sizeof defaults, shape.get()) == HS_OK);
  hs_block_def chosen = defaults;
  chosen.kind = HS_BLOCK_PRESCRIBED;
  chosen.pose = pose_at(0, 7, 0.6, 0.8);
  chosen.velocity[1] = 2;
  chosen.angular_velocity[2] = 3;
  const std::vector<std::size_t> ends = {offsetof(hs_block_def, material), offsetof(hs_block_def, pose),
                                         offsetof(hs_block_def, velocity),
                                         offsetof(hs_block_def, angular_velocity)};
  check_sizes(defaults, chosen, ends, [&](const hs_block_def* def) {
    const TwoBoxes scene;
    hs_block block = 0;
    require_ok(hs_world_add_block(scene.world.get(), shape.get(), def, &block), scene.context.get());
    return saved(scene.world.get());
  });
}

TEST_CASE("sizes of hs_body_def") {
  const hs_body_def defaults = body_def();
  hs_body_def chosen = defaults;
  chosen.material = 1;
  chosen.pose = pose_at(0, 7, 0.6, 0.8);
  chosen.velocity[1] = 2;
  check_sizes(defaults, chosen, {offsetof(hs_body_def, pose), offsetof(hs_body_def, velocity)},
              [&](const hs_body_def* def) {
                const TwoBoxes scene;
                hs_context* c = scene.context.get();
                std::int32_t material = -1;
                require_ok(hs_world_add_material(scene.world.get(), 500, &material), c);
                const hs_elasticity_def elasticity = elasticity_def(1e8);
                for (const std::int32_t of : {0, 1})
                  require_ok(hs_world_set_elasticity(scene.world.get(), of, &elasticity), c);
                const Mesh mesh = make_mesh(c, bar(2));
                hs_body body = 0;
                require_ok(hs_world_add_mesh(scene.world.get(), mesh.get(), def, nullptr, &body), c);
                return saved(scene.world.get());
              });
}

TEST_CASE("sizes of hs_action_def") {
  const hs_action_def defaults = action_def(HS_ACTION_FORCE);
  hs_action_def chosen = defaults;
  chosen.table = 1;
  chosen.place = HS_PLACE_FIXED;
  chosen.start = 2;
  chosen.scale[1] = 3;
  chosen.point[0] = 4;
  check_sizes(
      defaults, chosen,
      {offsetof(hs_action_def, table), offsetof(hs_action_def, place), offsetof(hs_action_def, start),
       offsetof(hs_action_def, scale), offsetof(hs_action_def, point), offsetof(hs_action_def, max_speed)},
      [](const hs_action_def* def) {
        ActionWorld scene(2);
        scene.add_table({0}, {{5, 6, 7}});
        scene.act(scene.rigid, *def);
        return saved(scene.world.get());
      });
}

TEST_CASE("sizes of hs_bond_def") {
  hs_bond_def defaults;
  REQUIRE(hs_bond_def_init(&defaults, sizeof defaults) == HS_OK);
  hs_bond_def chosen = defaults;
  chosen.normal_stiffness = 2e9;
  chosen.shear_stiffness = 3e9;
  chosen.tensile_strength = 1e5;
  chosen.cohesion = 2e5;
  chosen.friction_angle = 0.3;
  chosen.residual_cohesion = 1e4;
  chosen.residual_friction_angle = 0.2;
  chosen.tensile_fracture_energy = 10;
  chosen.shear_fracture_energy = 20;
  const std::vector<std::size_t> ends = {
      offsetof(hs_bond_def, normal_stiffness),        offsetof(hs_bond_def, shear_stiffness),
      offsetof(hs_bond_def, tensile_strength),        offsetof(hs_bond_def, cohesion),
      offsetof(hs_bond_def, friction_angle),          offsetof(hs_bond_def, residual_cohesion),
      offsetof(hs_bond_def, residual_friction_angle), offsetof(hs_bond_def, tensile_fracture_energy),
      offsetof(hs_bond_def, shear_fracture_energy)};
  for (const bool by_material : {false, true}) {
    check_sizes(defaults, chosen, ends, [&](const hs_bond_def* def) {
      const TwoBoxes scene;
      hs_world* w = scene.world.get();
      const hs_block beside = add_block(scene.context.get(), w, box(5, -1, 7, 0), HS_BLOCK_RIGID);
      require_ok(by_material ? hs_world_bond_materials(w, 0, 0, def, nullptr)
                             : hs_world_bond_blocks(w, scene.floor, beside, def),
                 scene.context.get());
      return saved(w);
    });
  }
}

TEST_CASE("sizes of hs_relaxation_def") {
  hs_relaxation_def defaults;
  REQUIRE(hs_relaxation_def_init(&defaults, sizeof defaults) == HS_OK);
  hs_relaxation_def chosen = defaults;
  chosen.measure = HS_UNBALANCED_LARGEST;
  chosen.ratio = 1e-3;
  chosen.max_steps = 7;
  chosen.local_damping = 0.5;
  chosen.is_adaptive = 0;
  chosen.hold_bonds = 0;
  const std::vector<std::size_t> ends = {
      offsetof(hs_relaxation_def, ratio), offsetof(hs_relaxation_def, max_steps),
      offsetof(hs_relaxation_def, local_damping), offsetof(hs_relaxation_def, is_adaptive),
      offsetof(hs_relaxation_def, hold_bonds)};
  check_sizes(defaults, chosen, ends, [](const hs_relaxation_def* def) {
    const TwoBoxes scene;
    require_ok(hs_world_remove_block(scene.world.get(), scene.box_away), scene.context.get());
    const double push[3] = {0, -1e3, 0}, none[3] = {0, 0, 0};
    require_ok(hs_world_set_applied_force(scene.world.get(), scene.box_on_floor, push, none),
               scene.context.get());
    if (hs_world_relax(scene.world.get(), def, nullptr, 0) < 0) throw std::runtime_error("not relaxed");
    return saved(scene.world.get());
  });
}

TEST_CASE("sizes of hs_strength_def") {
  hs_strength_def defaults;
  REQUIRE(hs_strength_def_init(&defaults, sizeof defaults) == HS_OK);
  hs_strength_def chosen = defaults;
  chosen.low = 0.7;
  chosen.high = 3;
  chosen.resolution = 1;
  chosen.ratio = 1e-3;
  chosen.max_displacement = 0.2;
  chosen.max_steps = 50;
  const std::vector<std::size_t> ends = {offsetof(hs_strength_def, low),
                                         offsetof(hs_strength_def, high),
                                         offsetof(hs_strength_def, ratio),
                                         offsetof(hs_strength_def, resolution),
                                         offsetof(hs_strength_def, max_displacement),
                                         offsetof(hs_strength_def, max_steps)};
  check_sizes(defaults, chosen, ends, [](const hs_strength_def* def) {
    const TwoBoxes scene;
    require_ok(hs_world_remove_block(scene.world.get(), scene.box_away), scene.context.get());
    hs_strength_report report{};
    require_ok(hs_world_find_strength_factor(scene.world.get(), def, &report, sizeof report, nullptr),
               scene.context.get());
    return bytes_of(report);
  });
}

TEST_CASE("sizes of hs_pair_options") {
  const TiltedPair pair;
  const hs_shape* square = pair.square.get();
  check_sizes(pair.defaults(), pair.chosen(), ends_of_option_fields, [&](const hs_pair_options* options) {
    hs_contact contact{};
    require_ok(hs_pair_detect(square, &pair.poses[0], square, &pair.poses[1], options, nullptr, &contact),
               pair.context.get());
    return bytes_of(contact);
  });
  check_sizes(pair.defaults(), pair.chosen(), ends_of_option_fields, [&](const hs_pair_options* options) {
    const hs_shape* shapes[2] = {square, square};
    const std::int32_t indices[2] = {0, 1};
    hs_contact contact{};
    require_ok(hs_pairs_detect(pair.context.get(), shapes, pair.poses, 2, indices, 1, options, nullptr,
                               &contact, nullptr),
               pair.context.get());
    return bytes_of(contact);
  });
}

TEST_CASE("sizes of hs_context_def") {
  long calls = 0;
  hs_context_def chosen;
  REQUIRE(hs_context_def_init(&chosen, sizeof chosen) == HS_OK);
  chosen.allocate = [](std::size_t bytes, std::size_t, void* user) {
    if (user) ++*static_cast<long*>(user);
    return std::malloc(bytes);
  };
  chosen.release = [](void* memory, std::size_t, std::size_t, void*) { std::free(memory); };
  chosen.user = &calls;
  const auto calls_with = [&](std::size_t size) {
    calls = 0;
    make_context(Resized<hs_context_def>(chosen, size).get());
    return calls;
  };
  CHECK(calls_with(sizeof chosen) == 1);
  CHECK(calls_with(sizeof chosen + 64) == 1);
  CHECK(calls_with(offsetof(hs_context_def, user)) == 0);      // user is NULL then
  CHECK(calls_with(offsetof(hs_context_def, allocate)) == 0);  // the C library's allocator
  hs_context* context = nullptr;
  const Resized<hs_context_def> half(chosen, offsetof(hs_context_def, release));
  CHECK(hs_context_create(half.get(), &context) == HS_ERROR_ARGUMENT);
}

}  // namespace halfspace_test
